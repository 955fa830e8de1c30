# An engine for Polhode: a free rigid body under uniform gravity, by the classical Runge-Kutta method.
#
# Run it:    polhode run free-asymmetric --scheme "engine:julia engine.jl" --steps 100
# Check it:  polhode engine check "julia engine.jl"
#
# Put your own simulator in the place of `rates` and `run_scene`. One JSON object a line on stdin and stdout; stderr
# is your own log. Standard library only; with JSON.jl the first part goes away.

using LinearAlgebra

# ---- as much JSON as the protocol needs ----

mutable struct Parser
    text::Vector{UInt8}
    at::Int
end

peek_byte(p) = p.at <= length(p.text) ? Char(p.text[p.at]) : '\0'

function next(p)
    while peek_byte(p) in (' ', '\t', '\r', '\n')
        p.at += 1
    end
    return peek_byte(p)
end

function parse_string(p)
    bytes = UInt8[]
    p.at += 1
    while peek_byte(p) != '"'
        peek_byte(p) == '\\' && (p.at += 1)
        push!(bytes, p.text[p.at])
        p.at += 1
    end
    p.at += 1
    return String(bytes)
end

function parse_value(p)
    first = next(p)
    if first == '"'
        return parse_string(p)
    elseif first == '[' || first == '{'
        list, members = Any[], Dict{String,Any}()
        p.at += 1
        while next(p) != ']' && peek_byte(p) != '}'
            if first == '{'
                key = parse_string(p)
                next(p)
                p.at += 1
                members[key] = parse_value(p)
            else
                push!(list, parse_value(p))
            end
            next(p) == ',' && (p.at += 1)
        end
        p.at += 1
        return first == '[' ? list : members
    end
    start = p.at
    while !(peek_byte(p) in (',', ']', '}', ' ', '\0'))
        p.at += 1
    end
    word = String(p.text[start:p.at-1])
    return word == "null" ? nothing : word == "true" ? true : word == "false" ? false : parse(Float64, word)
end

json(v::AbstractVector) = "[" * join(string.(v), ",") * "]"

# ---- the body ----

struct Refused <: Exception
    why::String
end

vector(list) = Float64.(list)

# R v: from body axes to world axes, q = (w, x, y, z).
function turned(q, v)
    axis = q[2:4]
    t = 2 .* cross(axis, v)
    return v .+ q[1] .* t .+ cross(axis, t)
end

# Time derivative of y = position, velocity, orientation, angular velocity in body axes.
function rates(y, gravity, inertia, inverted)
    w, x, z2, z = y[7:10]
    spin = y[11:13]
    a, b, c = spin
    turning = [-x * a - z2 * b - z * c, w * a + z2 * c - z * b, w * b + z * a - x * c, w * c + x * b - z2 * a]
    return vcat(y[4:6], gravity, 0.5 .* turning, inverted * cross(inertia * spin, spin))
end

function run_scene(request)
    request["pivot"] === nothing || throw(Refused("no pivot"))
    gravity = zeros(3)
    for force in request["forces"]
        force["law"] == "gravity" || throw(Refused("no law '$(force["law"])'"))
        gravity += vector(force["acceleration"])
    end
    inertia = reduce(vcat, [vector(row)' for row in request["body"]["inertia"]])
    abs(det(inertia)) < 1e-30 && throw(Refused("the inertia is singular: a rod or a point"))
    inverted = inv(inertia)
    initial, h = request["initial"], request["step"]
    steps, every = Int(request["steps"]), Int(request["every"])
    q = vector(initial["orientation"])
    spin = turned([q[1]; -q[2:4]], vector(initial["angular_velocity"]))
    y = vcat(vector(initial["position"]), vector(initial["velocity"]), q, spin)
    rate(state) = rates(state, gravity, inertia, inverted)
    states, began = String[], time_ns()
    for step in 0:steps
        if step % every == 0 || step == steps
            q = y[7:10] ./ norm(y[7:10])
            all(isfinite, y) || error("the state is no longer finite")
            push!(states, "{\"step\":$step,\"position\":$(json(y[1:3])),\"orientation\":$(json(q))," *
                          "\"velocity\":$(json(y[4:6])),\"angular_velocity\":$(json(turned(q, y[11:13])))}")
        end
        if step < steps
            k1 = rate(y)
            k2 = rate(y .+ h / 2 .* k1)
            k3 = rate(y .+ h / 2 .* k2)
            k4 = rate(y .+ h .* k3)
            y = y .+ h / 6 .* (k1 .+ 2 .* k2 .+ 2 .* k3 .+ k4)
        end
    end
    return "\"states\":[" * join(states, ",") * "],\"elapsed_ns\":$(time_ns() - began),\"evaluations\":$(4 * steps)"
end

function answer(request)
    id = Int(request["id"])
    try
        return "{\"id\":$id," * run_scene(request) * "}"
    catch error
        error isa Refused && return "{\"id\":$id,\"refused\":\"$(error.why)\"}"
        return "{\"id\":$id,\"failed\":\"$(nameof(typeof(error)))\"}"
    end
end

for line in eachline(stdin)
    request = parse_value(Parser(Vector{UInt8}(line), 1))
    request["ask"] == "bye" && break
    if request["ask"] == "hello"
        println("{\"polhode\":1,\"name\":\"my-engine\",\"version\":\"0.1\",\"scheme\":\"RK4\",\"order\":4," *
                "\"forces\":[\"gravity\"]}")
    else
        println(answer(request))
    end
    flush(stdout)
end
