// The free body of tests/engines/run in MuJoCo: mujoco STEP_S SPAN_S [rk4]
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>

int main(int n_arguments, char** arguments) {
    const double step = atof(arguments[1]), span = atof(arguments[2]);
    const char* xml = "body.xml";
    FILE* file = fopen(xml, "w");
    fprintf(file,
            "<mujoco><option gravity='0 0 0' timestep='%.17g' integrator='%s'/><worldbody><body><freejoint/>"
            "<inertial pos='0 0 0' mass='1' diaginertia='4 3 1.5'/></body></worldbody></mujoco>",
            step, n_arguments > 3 ? "RK4" : "Euler");
    fclose(file);
    char error[1000] = "";
    mjModel* model = mj_loadXML(xml, NULL, error, sizeof error);
    remove(xml);
    if (!model) return fprintf(stderr, "%s\n", error), 1;
    mjData* data = mj_makeData(model);
    data->qvel[3] = 1.2, data->qvel[4] = 0.8, data->qvel[5] = 2.4;  // of a free joint: body axes
    printf("time,q_w,q_x,q_y,q_z,omega_x,omega_y,omega_z\n");
    for (long k = 0; k * step <= span; ++k) {
        const double *q = data->qpos + 3, *w = data->qvel + 3;
        printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k * step, q[0], q[1], q[2], q[3], w[0], w[1], w[2]);
        mj_step(model, data);
    }
    return 0;
}
