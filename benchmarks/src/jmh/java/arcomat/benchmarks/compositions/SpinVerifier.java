package arcomat.benchmarks.compositions;

import arcomat.benchmarks.measure.Command;
import arcomat.benchmarks.measure.Folders;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Spin's verifier for a system: generated and compiled first, which is not counted. */
final class SpinVerifier {
    private static final Pattern STORED = Pattern.compile("(\\d+) states, stored");

    /** The least that suffices is taken: a longer stack takes more memory, and time to get it. */
    private static final List<String> DEPTHS =
            List.of("-m100000", "-m2000000", "-m4000000", "-m8000000", "-m16000000", "-m40000000");

    private SpinVerifier() {}

    static boolean isInstalled() {
        return Command.answers("spin", "-V") && Command.answers("gcc", "--version");
    }

    /**
     * Depth first, as it is fastest and does not store what is between two slices; its stack is as
     * long as that takes.
     */
    static UserTime run(ComposedSystem system) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("spin");
        try {
            Files.writeString(folder.resolve("system.pml"), PromelaWriter.text(system));
            shell(folder, "spin -a system.pml");
            shell(folder, "gcc -O2 -DSAFETY -DMEMLIM=12000 -o pan pan.c");
            UserTime time = search(folder, 0);
            if (!time.output().contains("errors: 0")) {
                throw new IllegalStateException(system.label() + " in Spin: " + time.output());
            }
            return time;
        } finally {
            Folders.delete(folder);
        }
    }

    /** With a longer stack, if need be: what does not suffice is not counted. */
    private static UserTime search(Path folder, int which)
            throws IOException, InterruptedException {
        UserTime time =
                UserTime.of(List.of(folder.resolve("pan").toString(), DEPTHS.get(which), "-w24"));
        boolean cut = time.output().contains("max search depth too small");
        return cut && which + 1 < DEPTHS.size() ? search(folder, which + 1) : time;
    }

    private static void shell(Path folder, String command)
            throws IOException, InterruptedException {
        Command.run(List.of("sh", "-c", "cd " + folder + " && " + command));
    }

    /** How many states it has stored. */
    static long stored(UserTime time) {
        Matcher matcher = STORED.matcher(time.output());
        if (!matcher.find()) {
            throw new IllegalStateException("Spin says nothing of states: " + time.output());
        }
        return Long.parseLong(matcher.group(1));
    }
}
