package arcomat.benchmarks.analysis;

import arcomat.benchmarks.measure.LoweredSources;
import arcomat.model.Model;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** From texts to what is compared. */
record Models(Model model) {

    /** Texts of components, each with its own file. */
    static Models of(String... texts) {
        List<SourceFile> sources = new ArrayList<>();
        sources.add(new SourceFile("load/Types.cd", Texts.types()));
        for (int i = 0; i < texts.length; i++) {
            sources.add(new SourceFile("load/" + i + ".arc", texts[i]));
        }
        return new Models(LoweredSources.of(sources));
    }

    /** The case study. */
    static Models coffee() throws IOException {
        Path root = Path.of("models", "coffee");
        List<SourceFile> sources = new ArrayList<>();
        try (Stream<Path> files = Files.walk(root)) {
            for (Path file :
                    files.filter(f -> f.toString().matches(".*/(fig\\d|types)/.*\\.(arc|cd)"))
                            .sorted()
                            .toList()) {
                sources.add(
                        new SourceFile(root.relativize(file).toString(), Files.readString(file)));
            }
        }
        return new Models(LoweredSources.of(sources));
    }

    Promise promise(String component) {
        return Promise.of(model.component(component).orElseThrow(), List.of());
    }
}
