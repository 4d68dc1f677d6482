package arcomat.pipeline.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;

import java.nio.file.Path;

/** The worlds of the case study, with the programs of their robots. */
final class Shipped {
    static final String MEETING = "meeting.world";
    static final String SERVICE = "service.world";

    private static final String FOLDER = "models/coffee/world/";

    private Shipped() {}

    static PreparedWorld world(String name) throws WrongUse {
        return at(FOLDER + name);
    }

    /** Any other one. */
    static PreparedWorld at(String path) throws WrongUse {
        PathNames names = new PathNames(Path.of("").toAbsolutePath());
        PreparedWorld world = new Session(names, Progress.NONE).run(new PrepareWorld(path, false));
        assertThat(world.findings()).isEmpty();
        return world;
    }
}
