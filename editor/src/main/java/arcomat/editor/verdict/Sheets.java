package arcomat.editor.verdict;

import arcomat.pipeline.verdict.TextVerdict;
import arcomat.pipeline.verdict.VerdictPlace;
import arcomat.source.Sha256;
import arcomat.symbols.names.Lazy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes what is to be looked at into a folder that lasts as long as the server. */
public final class Sheets {
    private final Lazy<Path> folder = new Lazy<>(Sheets::make);

    private static Path make() {
        try {
            Path folder = Files.createTempDirectory("arcomat-verdicts-");
            folder.toFile().deleteOnExit();
            return folder;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Each in a folder of its own, which is written again when it is asked for again. */
    public Path write(TextVerdict verdict) throws IOException {
        VerdictPlace place = verdict.place();
        String name = Sha256.hex(place.span().file().path() + place.kind() + place.name());
        Path own = Files.createDirectories(folder.get().resolve(name));
        own.toFile().deleteOnExit();
        Path file = own.resolve(verdict.sheet().file());
        Files.writeString(file, verdict.sheet().content().get());
        file.toFile().deleteOnExit();
        return file;
    }
}
