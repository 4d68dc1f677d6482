package arcomat.world;

import arcomat.source.SourceFile;

/** Worlds of tests, from their texts. */
final class Worlds {
    /** A robot that is as wide as it is simple. */
    static final String ROVER =
            """
            kind rover
              program jar Rover.jar
              body 80 900
              wheels A B diameter 56 track 112
              ultrasonic S1 at 75 0
              light S2 at 60 0
              bumper S3
            """;

    private Worlds() {}

    static World of(String text) {
        WorldParser.Parsed parsed = WorldParser.parse(new SourceFile("test.world", text));
        return parsed.world().orElseThrow(() -> new AssertionError(parsed.findings().toString()));
    }

    /** The scene after a while at constant speeds of the shafts. */
    static Scene drive(World world, double seconds, double[]... shafts) {
        Physics physics = new Physics(world, 1);
        Scene scene = physics.start();
        for (int step = 0; step < seconds * 1000 / Physics.STEP; step++) {
            scene = physics.step(scene, shafts);
        }
        return scene;
    }
}
