package arcomat.benchmarks.editor;

import arcomat.benchmarks.frontend.Texts;
import arcomat.benchmarks.measure.Folders;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A folder of a thousand components, a hundred of which have a part of the same type. */
final class Workshop implements AutoCloseable {
    /** A component that is a part of a hundred others; the port is in its line. */
    static final String SHARED = "load/Clock.arc";

    /** One of the hundred. */
    static final String USER = "load/Line50.arc";

    /** A large one, which is a part of {@link #USER}. */
    static final String CONTROLLER = "load/Controller50.arc";

    private static final int USERS = 100;
    private static final int CONTROLLERS = 899;

    private final Path folder;

    Workshop() throws IOException {
        folder = Files.createTempDirectory("workshop").toRealPath();
        Files.createDirectory(folder.resolve("load"));
        for (SourceFile model : Texts.models(CONTROLLERS)) {
            write(model.path(), model.text());
        }
        write(
                SHARED,
                """
                package load;

                component Clock {
                  port in Integer amount, out Integer late;
                }
                """);
        for (int user = 0; user < USERS; user++) {
            write("load/Line" + user + ".arc", user(user));
        }
    }

    private void write(String path, String text) throws IOException {
        Files.writeString(folder.resolve(path), text);
    }

    private static String user(int number) {
        return """
        package load;

        import load.Signals.*;

        component Line%d {
          port in Request request, in Integer amount, out Light light, out Integer total;

          component Clock clock;
          component Controller%d controller;

          connect amount -> clock.amount;
          connect request -> controller.request;
          connect clock.late -> controller.amount;
          connect controller.light -> light;
          connect controller.total -> total;
        }
        """
                .formatted(number, number);
    }

    Path folder() {
        return folder;
    }

    String text(String path) throws IOException {
        return Files.readString(folder.resolve(path));
    }

    @Override
    public void close() throws IOException {
        Folders.delete(folder);
    }
}
