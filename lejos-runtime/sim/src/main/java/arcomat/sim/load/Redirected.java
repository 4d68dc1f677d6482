package arcomat.sim.load;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;

/** The class files of a program with its calls redirected, and those of leJOS as they are. */
final class Redirected implements ClassFiles {
    private final Program program;
    private final Rewriter rewriter;
    private final List<Probe> probes;
    private final List<NotedLines> lines;
    private final boolean rests;

    /**
     * @param counted whether the program has the brick's memory, its calls and its speed
     * @param probes that are put into the program
     * @param lines that are noted
     * @param rests whether its main thread rests between slices; then it has the {@link
     *     GeneratedForm}
     * @throws IllegalArgumentException if the program brings classes of leJOS or of the simulation
     */
    Redirected(
            Program program,
            boolean counted,
            List<Probe> probes,
            List<NotedLines> lines,
            boolean rests) {
        for (String name : program.classes().keySet()) {
            if (BrickLoader.isShared(name) || BrickLoader.isInside(name)) {
                throw new IllegalArgumentException(name + " lies in a package of the simulation");
            }
        }
        this.program = program;
        this.probes = probes;
        this.lines = lines;
        this.rests = rests;
        this.rewriter = Rewriter.of(program.classes(), counted);
    }

    @Override
    public Optional<byte[]> find(String name) {
        return BrickLoader.isInside(name)
                ? simulated(name)
                : Optional.ofNullable(program.classes().get(name))
                        .map(rewriter::rewrite)
                        .map(file -> Probing.of(name, file, probes))
                        .map(file -> LineNoting.of(name, file, lines))
                        .map(file -> rests ? SliceLoop.resting(name, file) : file);
    }

    private static Optional<byte[]> simulated(String name) {
        String path = name.replace('.', '/') + ".class";
        try (InputStream stream = Redirected.class.getClassLoader().getResourceAsStream(path)) {
            return stream == null ? Optional.empty() : Optional.of(stream.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + name, e);
        }
    }
}
