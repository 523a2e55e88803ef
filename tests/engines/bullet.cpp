// The free body of tests/engines/run in Bullet: bullet STEP_S SPAN_S [none]: without gyroscopic
// forces
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <cstdlib>

int main(int n_arguments, char** arguments) {
    const double step = std::atof(arguments[1]), span = std::atof(arguments[2]);
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.setGravity({0, 0, 0});
    btSphereShape shape(0.1F);
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, {4, 3, 1.5F}));
    body.setDamping(0, 0);
    body.setActivationState(DISABLE_DEACTIVATION);
    if (n_arguments > 3) body.setFlags(0);
    body.setAngularVelocity({1.2F, 0.8F, 2.4F});
    world.addRigidBody(&body);
    std::printf("time,q_w,q_x,q_y,q_z,omega_x,omega_y,omega_z\n");
    for (long k = 0; k * step <= span; ++k) {
        const btQuaternion q = body.getOrientation();
        const btVector3 w = quatRotate(q.inverse(), body.getAngularVelocity());
        std::printf("%.17g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", k * step, q.w(), q.x(), q.y(),
                    q.z(), w.x(), w.y(), w.z());
        world.stepSimulation(static_cast<btScalar>(step), 0);
    }
}
