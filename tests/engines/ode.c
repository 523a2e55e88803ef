// The free body of tests/engines/run in ODE: ode STEP_S SPAN_S
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>

int main(int n_arguments, char** arguments) {
    const double step = atof(arguments[1]), span = atof(arguments[2]);
    (void)n_arguments;
    dInitODE2(0);
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 4, 3, 1.5, 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetAngularVel(body, 1.2, 0.8, 2.4);
    printf("time,q_w,q_x,q_y,q_z,omega_x,omega_y,omega_z\n");
    for (long k = 0; k * step <= span; ++k) {
        const dReal *q = dBodyGetQuaternion(body), *w = dBodyGetAngularVel(body);
        dVector3 in_body;
        dBodyVectorFromWorld(body, w[0], w[1], w[2], in_body);
        printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k * step, q[0], q[1], q[2], q[3], in_body[0],
               in_body[1], in_body[2]);
        dWorldStep(world, step);
    }
    return 0;
}
