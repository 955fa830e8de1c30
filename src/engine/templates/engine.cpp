// An engine for Polhode: a free rigid body under uniform gravity, by the classical Runge-Kutta method.
//
// Build it:  c++ -std=c++17 -O2 -o engine engine.cpp
// Run it:    polhode run free-asymmetric --scheme engine:./engine --steps 100
// Check it:  polhode engine check ./engine
//
// Put your own simulator in the place of `rates` and `run`. One JSON object a line on stdin and stdout; stderr is
// your own log. No library but the standard one.
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// ---- as much JSON as the protocol needs ----

struct Json {
    bool null = true;
    double number = 0;
    std::string text;
    std::vector<Json> list;
    std::map<std::string, std::shared_ptr<Json>> members;
    const Json& operator[](const std::string& key) const { return *members.at(key); }
};

struct Parser {
    const char* p;

    char next() {
        while (*p == ' ' || *p == '\n' || *p == '\r' || *p == '\t') p++;
        return *p;
    }
    std::string string() {
        std::string text;
        for (p++; *p && *p != '"'; p++) text += *p == '\\' && p[1] ? *++p : *p;
        p++;
        return text;
    }
    Json value() {
        Json json;
        json.null = false;
        const char first = next();
        if (first == '"') {
            json.text = string();
        } else if (first == '[' || first == '{') {
            const char last = first == '[' ? ']' : '}';
            for (p++; next() != last && *p; p += next() == ',') {
                if (first == '[') {
                    json.list.push_back(value());
                    continue;
                }
                const std::string key = string();
                next(), p++;
                json.members[key] = std::make_shared<Json>(value());
            }
            p++;
        } else if (first == 'n') {
            json.null = true, p += 4;
        } else if (first == 't' || first == 'f') {
            json.number = first == 't', p += first == 't' ? 4 : 5;
        } else {
            char* end;
            json.number = std::strtod(p, &end);
            if (end == p) throw std::runtime_error("not JSON");
            p = end;
        }
        return json;
    }
};

// ---- the body ----

struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;
using Quaternion = std::array<double, 4>;

struct State {
    Vector position, velocity;
    Quaternion q;  // (w, x, y, z), from body axes to world axes
    Vector spin;   // body axes
};

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector operator*(const Matrix& m, const Vector& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Matrix inverse(const Matrix& m) {
    const Matrix rows = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    const double determinant = dot(m[0], rows[0]);
    if (std::abs(determinant) < 1e-30) throw Refused("the inertia is singular: a rod or a point");
    Matrix out;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) out[i][j] = rows[j][i] / determinant;
    return out;
}

Vector turned(const Quaternion& q, const Vector& v) {
    const Vector axis = {q[1], q[2], q[3]}, t = 2.0 * cross(axis, v);
    return v + q[0] * t + cross(axis, t);
}

struct Body {
    Vector gravity{};
    Matrix inertia{}, inverted{};

    State rates(const State& y) const {
        const auto& [w, x, z2, z] = y.q;
        const auto& [a, b, c] = y.spin;
        const Quaternion turning = {0.5 * (-x * a - z2 * b - z * c), 0.5 * (w * a + z2 * c - z * b),
                                    0.5 * (w * b + z * a - x * c), 0.5 * (w * c + x * b - z2 * a)};
        return {y.velocity, gravity, turning, inverted * cross(inertia * y.spin, y.spin)};
    }
};

State moved(const State& y, double s, const State& k) {
    State out = {y.position + s * k.position, y.velocity + s * k.velocity, y.q, y.spin + s * k.spin};
    for (int i = 0; i < 4; i++) out.q[i] += s * k.q[i];
    return out;
}

State step(const Body& body, double h, const State& y) {
    const State k1 = body.rates(y), k2 = body.rates(moved(y, h / 2, k1));
    const State k3 = body.rates(moved(y, h / 2, k2)), k4 = body.rates(moved(y, h, k3));
    return moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

template <std::size_t N>
std::array<double, N> numbers(const Json& json) {
    std::array<double, N> out;
    for (std::size_t i = 0; i < N; i++) out[i] = json.list.at(i).number;
    return out;
}

template <std::size_t N>
void write(std::ostream& out, const char* name, const std::array<double, N>& v) {
    out << ",\"" << name << "\":[";
    for (std::size_t i = 0; i < N; i++) {
        if (!std::isfinite(v[i])) throw std::runtime_error("the state is no longer finite");
        out << (i ? "," : "") << v[i];
    }
    out << "]";
}

std::string run(const Json& request) {
    Body body;
    if (!request["pivot"].null) throw Refused("no pivot");
    for (const Json& force : request["forces"].list) {
        if (force["law"].text != "gravity") throw Refused("no law '" + force["law"].text + "'");
        body.gravity = body.gravity + numbers<3>(force["acceleration"]);
    }
    for (int i = 0; i < 3; i++) body.inertia[i] = numbers<3>(request["body"]["inertia"].list.at(i));
    body.inverted = inverse(body.inertia);
    const Json& initial = request["initial"];
    State y = {numbers<3>(initial["position"]), numbers<3>(initial["velocity"]),
               numbers<4>(initial["orientation"]), {}};
    y.spin = turned({y.q[0], -y.q[1], -y.q[2], -y.q[3]}, numbers<3>(initial["angular_velocity"]));
    const double h = request["step"].number;
    const auto steps = static_cast<long long>(request["steps"].number);
    const auto every = static_cast<long long>(request["every"].number);
    std::ostringstream out;
    out << std::setprecision(17) << "\"states\":[";
    const auto began = std::chrono::steady_clock::now();
    for (long long number = 0; number <= steps; number++) {
        if (number % every == 0 || number == steps) {
            const double length = std::sqrt(y.q[0] * y.q[0] + y.q[1] * y.q[1] + y.q[2] * y.q[2] + y.q[3] * y.q[3]);
            const Quaternion q = {y.q[0] / length, y.q[1] / length, y.q[2] / length, y.q[3] / length};
            out << (number ? "," : "") << "{\"step\":" << number;
            write(out, "position", y.position), write(out, "orientation", q), write(out, "velocity", y.velocity);
            write(out, "angular_velocity", turned(q, y.spin)), out << "}";
        }
        if (number < steps) y = step(body, h, y);
    }
    const std::chrono::nanoseconds elapsed = std::chrono::steady_clock::now() - began;
    out << "],\"elapsed_ns\":" << elapsed.count() << ",\"evaluations\":" << 4 * steps;
    return out.str();
}

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        const Json request = Parser{line.c_str()}.value();
        const std::string ask = request["ask"].text;
        if (ask == "bye") break;
        if (ask == "hello") {
            std::cout << R"({"polhode":1,"name":"my-engine","version":"0.1","scheme":"RK4","order":4,)"
                      << R"("forces":["gravity"]})" << std::endl;
            continue;
        }
        std::cout << "{\"id\":" << static_cast<long long>(request["id"].number) << ",";
        try {
            std::cout << run(request);
        } catch (const Refused& why) {
            std::cout << "\"refused\":\"" << why.what() << "\"";
        } catch (const std::exception& why) {
            std::cout << "\"failed\":\"" << why.what() << "\"";
        }
        std::cout << "}" << std::endl;
    }
}
