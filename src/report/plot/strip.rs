//! A picture drawn strip by strip: pixels of one strip at a time are in memory, each the same as if the whole were drawn at once.

use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, DrawingBackend, DrawingErrorKind, rasterizer,
};

/// A backend of the whole picture's size that keeps the rows of one strip and lets all others go.
pub(super) struct Strip<B> {
    inner: B,
    /// Of the whole picture [pixels].
    size: (u32, u32),
    /// The strip's first row.
    first: i32,
}

impl<B: DrawingBackend> Strip<B> {
    /// The rows from `first` on that `inner` has room for, of a picture of this size.
    pub(super) fn new(inner: B, size: (u32, u32), first: u32) -> Strip<B> {
        Strip { inner, size, first: first as i32 }
    }

    fn inside(&self, (x, y): BackendCoord) -> BackendCoord {
        (x, y - self.first)
    }
}

impl<B: DrawingBackend> DrawingBackend for Strip<B> {
    type ErrorType = B::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        self.inner.ensure_prepared()
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        self.inner.present()
    }

    fn draw_pixel(
        &mut self,
        point: BackendCoord,
        color: BackendColor,
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        self.inner.draw_pixel(self.inside(point), color)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        // Along a row or a column a shift changes nothing; askew, where the line is cut decides which pixels it takes.
        if (from.0 == to.0 || from.1 == to.1) && style.stroke_width() == 1 {
            return self.inner.draw_line(self.inside(from), self.inside(to), style);
        }
        rasterizer::draw_line(self, from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        if fill {
            return self.inner.draw_rect(self.inside(upper_left), self.inside(bottom_right), style, fill);
        }
        rasterizer::draw_rect(self, upper_left, bottom_right, style, fill)
    }
}
