package statemachine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import statemachine.ReferenceMachine.SentTwice;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Random;
import java.util.Set;

/** Machines that are drawn by lot allow what their references do, and nothing else. */
class UnfoldingTest {
    private static final int MACHINES = Integer.getInteger("machines", 20);
    private static final long SEED = Long.getLong("seed", 39);

    /** Machines with more situations are left out. */
    private static final int MOST = 100;

    @TempDir private Path folder;

    @Test
    void keepsWhatTheReferencePromisesAndNothingMore() throws Exception {
        Random random = new Random(SEED);
        int compared = 0;
        for (int i = 0; i < MACHINES; i++) {
            DrawnMachine machine = DrawnMachine.draw(random);
            Optional<UnfoldedMachine> unfolded =
                    UnfoldedMachine.of(new ReferenceMachine(machine), MOST);
            if (unfolded.isPresent()) {
                UnfoldedMachine plain = unfolded.get();
                String name = "Machine" + i;
                write(name, machine.text(name + " refines Plain" + i));
                write("Plain" + i, plain.text("Plain" + i));
                write("Again" + i, plain.text("Again" + i + " refines " + name));
                compared++;
            }
        }
        String printed = Tool.run(folder, "verify", ".");
        assertThat(printed.lines().filter(line -> !line.startsWith("holds ")))
                .as("seed %d", SEED)
                .containsExactly("%d hold, 0 fail, 0 unknown".formatted(2 * compared));
        assertThat(compared).isGreaterThan(MACHINES / 2);
    }

    @Test
    void whatIsSentTwiceIsTold() throws Exception {
        Random random = new Random(SEED);
        Set<String> twice = new LinkedHashSet<>();
        for (int i = 0; i < MACHINES; i++) {
            DrawnMachine machine = DrawnMachine.draw(random, true);
            String name = "Machine" + i;
            write(name, machine.text(name));
            try {
                UnfoldedMachine.of(new ReferenceMachine(machine), MOST);
            } catch (SentTwice e) {
                twice.add(name);
            }
        }
        String printed = Tool.run(folder, "check", ".");
        Set<String> told = new LinkedHashSet<>();
        printed.lines()
                .filter(line -> line.contains(": error STM0007: "))
                .forEach(line -> told.add(line.substring(0, line.indexOf(".arc:"))));
        assertThat(told).as("seed %d", SEED).containsAll(twice);
        assertThat(twice.size()).isBetween(MACHINES / 5, MACHINES - 1);
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name + ".arc"), text);
    }
}
