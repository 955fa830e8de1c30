/* An engine for Polhode: a free rigid body under uniform gravity, by the classical Runge-Kutta method.
 *
 * Build it:  cc -O2 -o engine engine.c -lm
 * Run it:    polhode run free-asymmetric --scheme engine:./engine --steps 100
 * Check it:  polhode engine check ./engine
 *
 * Put your own simulator in the place of `rates` and `run`. One JSON object a line on stdin and stdout; stderr is
 * your own log. POSIX C, no library.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- as much JSON as the protocol needs ---- */

static const char *skip_string(const char *p) {
    for (p++; *p && *p != '"'; p++)
        if (*p == '\\' && p[1]) p++;
    return *p ? p + 1 : p;
}

/* The value of a key of the object at p, or NULL. */
static const char *value(const char *p, const char *key) {
    size_t length = strlen(key);
    int depth = 0;
    while (*p) {
        if (*p == '"') {
            const char *name = p + 1;
            p = skip_string(p);
            if (depth == 1 && *p == ':' && strncmp(name, key, length) == 0 && name[length] == '"')
                return p + 1 + strspn(p + 1, " ");
            continue;
        }
        if (*p == '{' || *p == '[') depth++;
        if ((*p == '}' || *p == ']') && --depth == 0) return NULL;
        p++;
    }
    return NULL;
}

/* Reads count numbers, through any brackets. */
static void numbers(const char *p, double *out, int count) {
    for (int i = 0; i < count && p; i++) {
        while (*p == '[' || *p == ']' || *p == ',' || *p == ' ') p++;
        char *end;
        out[i] = strtod(p, &end);
        p = end;
    }
}

/* ---- the body ---- */

typedef struct {
    double gravity[3], inertia[9], inverted[9];
} Body;

static void cross(const double *a, const double *b, double *out) {
    double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    out[0] = x, out[1] = y, out[2] = z;
}

static void apply(const double *m, const double *v, double *out) {
    for (int i = 0; i < 3; i++) out[i] = m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2];
}

static int invert(const double *m, double *out) {
    double rows[9], determinant = 0;
    for (int i = 0; i < 3; i++) cross(m + 3 * ((i + 1) % 3), m + 3 * ((i + 2) % 3), rows + 3 * i);
    for (int i = 0; i < 3; i++) determinant += m[i] * rows[i];
    if (fabs(determinant) < 1e-30) return 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) out[3 * i + j] = rows[3 * j + i] / determinant;
    return 1;
}

/* R v: from body axes to world axes, q = (w, x, y, z). */
static void turn(const double *q, const double *v, double *out) {
    double t[3], u[3];
    cross(q + 1, v, t);
    for (int i = 0; i < 3; i++) t[i] *= 2;
    cross(q + 1, t, u);
    for (int i = 0; i < 3; i++) out[i] = v[i] + q[0] * t[i] + u[i];
}

/* Time derivative of y = position, velocity, orientation, angular velocity in body axes. */
static void rates(const Body *body, const double *y, double *out) {
    const double *q = y + 6, *s = y + 10;
    double momentum[3], torque[3];
    for (int i = 0; i < 3; i++) out[i] = y[3 + i], out[3 + i] = body->gravity[i];
    out[6] = 0.5 * (-q[1] * s[0] - q[2] * s[1] - q[3] * s[2]);
    out[7] = 0.5 * (q[0] * s[0] + q[2] * s[2] - q[3] * s[1]);
    out[8] = 0.5 * (q[0] * s[1] + q[3] * s[0] - q[1] * s[2]);
    out[9] = 0.5 * (q[0] * s[2] + q[1] * s[1] - q[2] * s[0]);
    apply(body->inertia, s, momentum);
    cross(momentum, s, torque);
    apply(body->inverted, torque, out + 10);
}

static void step(const Body *body, double h, double *y) {
    static const double at[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    double k[13] = {0}, sum[13] = {0}, moved[13];
    for (int stage = 0; stage < 4; stage++) {
        for (int i = 0; i < 13; i++) moved[i] = y[i] + at[stage] * h * k[i];
        rates(body, moved, k);
        for (int i = 0; i < 13; i++) sum[i] += weight[stage] * k[i];
    }
    for (int i = 0; i < 13; i++) y[i] += h / 6 * sum[i];
}

static void print_vector(const char *name, const double *v, int count) {
    printf("\"%s\":[", name);
    for (int i = 0; i < count; i++) printf(i ? ",%.17g" : "%.17g", v[i]);
    printf("]");
}

static void print_state(long long number, const double *y) {
    double length = sqrt(y[6] * y[6] + y[7] * y[7] + y[8] * y[8] + y[9] * y[9]), q[4], spin[3];
    for (int i = 0; i < 4; i++) q[i] = y[6 + i] / length;
    turn(q, y + 10, spin);
    printf("%s{\"step\":%lld,", number ? "," : "", number);
    print_vector("position", y, 3), printf(",");
    print_vector("orientation", q, 4), printf(",");
    print_vector("velocity", y + 3, 3), printf(",");
    print_vector("angular_velocity", spin, 3), printf("}");
}

/* Adds the gravity of every law; returns the first other law, or NULL. */
static const char *read_forces(const char *p, Body *body) {
    for (p = p ? strchr(p, '{') : NULL; p;) {
        const char *law = value(p, "law");
        if (strncmp(law, "\"gravity\"", 9) != 0) return law;
        double g[3] = {0};
        numbers(value(p, "acceleration"), g, 3);
        for (int i = 0; i < 3; i++) body->gravity[i] += g[i];
        p = strchr(p, '}') + 1;
        p = *p == ',' ? p + 1 : NULL;
    }
    return NULL;
}

static void run(const char *request) {
    const char *given = value(request, "body"), *initial = value(request, "initial");
    long long id = atoll(value(request, "id")), steps = atoll(value(request, "steps"));
    long long every = atoll(value(request, "every"));
    double h = strtod(value(request, "step"), NULL), y[13], spin[3];
    Body body = {{0}, {0}, {0}};
    printf("{\"id\":%lld,", id);
    if (strncmp(value(request, "pivot"), "null", 4) != 0) {
        printf("\"refused\":\"no pivot\"}\n");
        return;
    }
    const char *forces = value(request, "forces");
    const char *law = strncmp(forces, "[]", 2) == 0 ? NULL : read_forces(forces, &body);
    if (law) {
        printf("\"refused\":\"no law '%.*s'\"}\n", (int)strcspn(law + 1, "\""), law + 1);
        return;
    }
    numbers(value(given, "inertia"), body.inertia, 9);
    if (!invert(body.inertia, body.inverted)) {
        printf("\"refused\":\"the inertia is singular: a rod or a point\"}\n");
        return;
    }
    numbers(value(initial, "position"), y, 3);
    numbers(value(initial, "velocity"), y + 3, 3);
    numbers(value(initial, "orientation"), y + 6, 4);
    numbers(value(initial, "angular_velocity"), spin, 3);
    double to_body[4] = {y[6], -y[7], -y[8], -y[9]};
    turn(to_body, spin, y + 10);
    long long nanoseconds = 0;
    printf("\"states\":[");
    for (long long number = 0;; number++) {
        if (number % every == 0 || number == steps) print_state(number, y);
        if (number == steps) break;
        struct timespec from, to;
        clock_gettime(CLOCK_MONOTONIC, &from);
        step(&body, h, y);
        clock_gettime(CLOCK_MONOTONIC, &to);
        nanoseconds += (to.tv_sec - from.tv_sec) * 1000000000LL + (to.tv_nsec - from.tv_nsec);
    }
    printf("],\"elapsed_ns\":%lld,\"evaluations\":%lld}\n", nanoseconds, 4 * steps);
}

int main(void) {
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, stdin) > 0) {
        const char *ask = value(line, "ask");
        if (!ask || strncmp(ask, "\"bye\"", 5) == 0) break;
        if (strncmp(ask, "\"hello\"", 7) == 0)
            puts("{\"polhode\":1,\"name\":\"my-engine\",\"version\":\"0.1\",\"scheme\":\"RK4\",\"order\":4,"
                 "\"forces\":[\"gravity\"]}");
        else
            run(line);
        fflush(stdout);
    }
    free(line);
    return 0;
}
