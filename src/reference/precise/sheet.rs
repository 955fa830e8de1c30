//! Operations written down by values that add and multiply like numbers; what is constant is worked out on the way.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::double_double::DoubleDouble;
use super::tape::Tape;

/// An operation on the tape; operands are places on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operation {
    Constant(DoubleDouble),
    Variable,
    Sum(usize, usize),
    Difference(usize, usize),
    Scaled(usize, DoubleDouble),
    Product(usize, usize),
    Quotient(usize, usize),
    Root(usize),
}

/// Where operations are written.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    operations: RefCell<Vec<Operation>>,
    variables: RefCell<Vec<usize>>,
}

/// A value on the sheet.
#[derive(Clone, Copy)]
pub(super) struct Node<'a> {
    sheet: &'a Sheet,
    index: usize,
}

impl Sheet {
    fn write(&self, operation: Operation) -> Node<'_> {
        let mut operations = self.operations.borrow_mut();
        operations.push(operation);
        Node { sheet: self, index: operations.len() - 1 }
    }

    pub(super) fn constant(&self, value: impl Into<DoubleDouble>) -> Node<'_> {
        self.write(Operation::Constant(value.into()))
    }

    /// The next variable of the equations.
    pub(super) fn variable(&self) -> Node<'_> {
        let node = self.write(Operation::Variable);
        self.variables.borrow_mut().push(node.index);
        node
    }

    /// The tape whose variables have these rates, or that shows these values, and works out what else is watched; what
    /// they do not need is left out.
    pub(super) fn tape(&self, values: &[Node], watched: &[Node]) -> Tape {
        let operations = self.operations.borrow().clone();
        let mut needed = vec![false; operations.len()];
        values.iter().chain(watched).for_each(|value| needed[value.index] = true);
        for index in (0..operations.len()).rev().filter(|index| needed[*index]).collect::<Vec<_>>() {
            mark(&operations, index, &mut needed);
        }
        let steps = (0..operations.len()).filter(|index| needed[*index]).collect();
        let variables = self.variables.borrow().clone();
        Tape { operations, steps, variables, values: values.iter().map(|value| value.index).collect() }
    }
}

/// Marks what an operation needs.
fn mark(operations: &[Operation], index: usize, needed: &mut [bool]) {
    needed[index] = true;
    let operands = match operations[index] {
        Operation::Constant(_) | Operation::Variable => [None, None],
        Operation::Scaled(a, _) | Operation::Root(a) => [Some(a), None],
        Operation::Sum(a, b)
        | Operation::Difference(a, b)
        | Operation::Product(a, b)
        | Operation::Quotient(a, b) => [Some(a), Some(b)],
    };
    for operand in operands.into_iter().flatten().collect::<Vec<_>>() {
        if !needed[operand] {
            mark(operations, operand, needed);
        }
    }
}

impl<'a> Node<'a> {
    /// Its place on the tape.
    pub(super) fn place(self) -> usize {
        self.index
    }

    fn value(self) -> Option<DoubleDouble> {
        match self.sheet.operations.borrow()[self.index] {
            Operation::Constant(value) => Some(value),
            _ => None,
        }
    }

    fn is_zero(self) -> bool {
        self.value().is_some_and(|value| value.high == 0.0)
    }

    pub(super) fn times(self, factor: impl Into<DoubleDouble>) -> Node<'a> {
        let factor = factor.into();
        match self.value() {
            Some(value) => self.sheet.constant(value * factor),
            None if factor.high == 0.0 => self.sheet.constant(0.0),
            None if factor == DoubleDouble::ONE => self,
            None => self.sheet.write(Operation::Scaled(self.index, factor)),
        }
    }

    pub(super) fn sqrt(self) -> Node<'a> {
        match self.value() {
            Some(value) => self.sheet.constant(value.sqrt()),
            None => self.sheet.write(Operation::Root(self.index)),
        }
    }
}

impl<'a> Add for Node<'a> {
    type Output = Node<'a>;

    fn add(self, other: Node<'a>) -> Node<'a> {
        match (self.value(), other.value()) {
            (Some(a), Some(b)) => self.sheet.constant(a + b),
            _ if self.is_zero() => other,
            _ if other.is_zero() => self,
            _ => self.sheet.write(Operation::Sum(self.index, other.index)),
        }
    }
}

impl<'a> Sub for Node<'a> {
    type Output = Node<'a>;

    fn sub(self, other: Node<'a>) -> Node<'a> {
        match (self.value(), other.value()) {
            (Some(a), Some(b)) => self.sheet.constant(a - b),
            _ if self.is_zero() => -other,
            _ if other.is_zero() => self,
            _ => self.sheet.write(Operation::Difference(self.index, other.index)),
        }
    }
}

impl<'a> Neg for Node<'a> {
    type Output = Node<'a>;

    fn neg(self) -> Node<'a> {
        self.times(-1.0)
    }
}

impl<'a> Mul for Node<'a> {
    type Output = Node<'a>;

    fn mul(self, other: Node<'a>) -> Node<'a> {
        match (self.value(), other.value()) {
            (Some(a), _) => other.times(a),
            (_, Some(b)) => self.times(b),
            _ => self.sheet.write(Operation::Product(self.index, other.index)),
        }
    }
}

impl<'a> Div for Node<'a> {
    type Output = Node<'a>;

    fn div(self, other: Node<'a>) -> Node<'a> {
        match other.value() {
            Some(value) => self.times(DoubleDouble::ONE / value),
            None => self.sheet.write(Operation::Quotient(self.index, other.index)),
        }
    }
}
