package arcomat.pipeline.generate;

import arcomat.generate.Target;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.FileReader;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Finds targets: shipped ones by name, a user's own by folder. */
public final class Targets {
    private Targets() {}

    /**
     * @param written a shipped target's name, or a folder
     * @throws WrongUse where it is neither, or the folder holds no target
     */
    public static Target find(String written, PathNames names) throws WrongUse {
        Optional<Target> shipped = Target.shipped(written);
        if (shipped.isPresent()) {
            return shipped.get();
        }
        Path folder = names.resolve(written);
        if (!Files.isDirectory(folder)) {
            throw new WrongUse(
                    "there is no target '%s': neither shipped (jvm, lejos) nor a folder of"
                            + " templates",
                    written);
        }
        if (!Files.exists(folder.resolve(Target.DESCRIPTION))) {
            throw new WrongUse(
                    "folder '" + written + "' is no target: it has no " + Target.DESCRIPTION);
        }
        Target target = new Target(written, texts(folder, written));
        Optional<String> base = baseName(target, written);
        return base.isPresent() ? target.on(Optional.of(base(base.get(), written))) : target;
    }

    private static Optional<String> baseName(Target target, String written) throws WrongUse {
        try {
            return target.baseName();
        } catch (IllegalArgumentException noProperties) { // the one thing that these can have wrong
            throw new WrongUse(
                    "%s/%s: a backslash and a u without four hexadecimal digits behind them",
                    written, Target.DESCRIPTION);
        }
    }

    private static Target base(String name, String written) throws WrongUse {
        return Target.shipped(name)
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "target '%s' stands on base '%s', which is not a shipped"
                                                + " target (jvm, lejos)",
                                        written, name));
    }

    private static Map<String, String> texts(Path folder, String written) throws WrongUse {
        Map<String, String> texts = new TreeMap<>();
        for (Path file : files(folder, written)) {
            String name = folder.relativize(file).toString().replace('\\', '/');
            texts.put(name, FileReader.text(file, written + "/" + name).text());
        }
        return texts;
    }

    static List<Path> files(Path folder, String written) throws WrongUse {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.filter(Files::isRegularFile)
                    .filter(p -> !p.getFileName().toString().startsWith("."))
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw Failures.cannot("read", written, e);
        }
    }
}
