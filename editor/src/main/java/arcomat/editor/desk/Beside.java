package arcomat.editor.desk;

import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.TextsAround;
import arcomat.pipeline.brick.ScriptLines;
import arcomat.pipeline.campaign.CampaignLines;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.pipeline.world.WorldLines;
import arcomat.source.SourceFile;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Function;

/**
 * Texts beside models, by the ends of their names.
 *
 * @param screen what is open
 * @param models all that there are
 */
record Beside(Function<Path, Optional<SourceFile>> screen, Collection<OpenModels> models)
        implements TextsAround {
    Optional<BesideText> text(Path place, SourceFile text) {
        String name = place.toString();
        if (name.endsWith(".world")) {
            return Optional.of(new WorldLines(text, place, this));
        }
        if (name.endsWith(".campaign")) {
            return Optional.of(new CampaignLines(text, place, this));
        }
        return name.endsWith(".script") ? Optional.of(new ScriptLines(text)) : Optional.empty();
    }

    @Override
    public Optional<SourceFile> text(Path file) {
        return screen.apply(file)
                .or(
                        () ->
                                Files.isRegularFile(file)
                                        ? FileReader.read(file, file.toString()).file()
                                        : Optional.empty());
    }

    @Override
    public Collection<OpenModels> all() {
        return models;
    }

    /** Tests lie beside models in a build, and both belong to a folder above. */
    @Override
    public Optional<OpenModels> models(Path root) {
        return models.stream()
                .filter(each -> root.startsWith(each.root()))
                .max(Comparator.comparing(each -> each.root().getNameCount()));
    }
}
