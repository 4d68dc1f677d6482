package arcomat.cluster.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A campaign with every kind of question. */
final class Questions {
    private static final String NAME = "questions.campaign";

    private Questions() {}

    static void write(Path folder) throws IOException {
        Path world = Path.of(System.getProperty("models"), "world", "meeting.world");
        Files.writeString(
                folder.resolve(NAME),
                """
                world %s
                vary light from 0 to 2
                sample random 300
                stop decided
                require collision below 0.1 at 95
                watch calm coffee.floor.Caution
                event near when empty.x >= 1000
                worst smallest distance runs 20
                split on distance levels 90 60 runs 10
                """
                        .formatted(folder.toRealPath().relativize(world.toRealPath())));
    }

    /** The command of that campaign. */
    static List<String> asked(List<String> command, String... options) {
        List<String> all = new ArrayList<>(command);
        all.add(NAME);
        all.addAll(List.of(options));
        return all;
    }
}
