package arcomat.editor.server;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.guest.host.Guests;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** What comes while the worker reads models. */
class WorkerTest {
    /** They take a second to be read; who opens one comes after milliseconds. */
    private static final int FILES = 600;

    private static final String TRANSITION = "        s -> s {a == 1} / {o = 1};\n";

    @TempDir private Path folder;

    @Test
    void whoOpensAFileWaitsForAFewOfTheOthersOnly() throws Exception {
        folder = folder.toRealPath();
        Files.createDirectory(folder.resolve("p"));
        for (int i = 0; i < FILES; i++) {
            Files.writeString(place(i), model(i));
        }
        Worker worker = new Worker(Guests.NONE, checked -> {});
        worker.edit(desk -> desk.add(folder));
        // Answered between two steps: the worker has begun to read.
        worker.ask((desk, canceled) -> folder).get(1, TimeUnit.MINUTES);
        CompletableFuture<Boolean> looked = new CompletableFuture<>();
        String text = model(FILES / 2);
        worker.edit(
                desk -> {
                    desk.open(place(FILES / 2), text);
                    looked.complete(desk.firstLook(place(FILES / 2)).isPresent());
                });
        assertThat(looked.get(1, TimeUnit.MINUTES)).isTrue();
        worker.end();
    }

    private Path place(int number) {
        return folder.resolve("p/Part" + number + ".arc");
    }

    private static String model(int number) {
        return """
        package p;

        component Part%d {
            port in Integer[0..9] a, out Integer[0..9] o;

            automaton {
                state s;
                initial s;
        %s    }
        }
        """
                .formatted(number, TRANSITION.repeat(40));
    }
}
