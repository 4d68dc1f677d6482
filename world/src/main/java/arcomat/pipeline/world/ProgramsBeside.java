package arcomat.pipeline.world;

import arcomat.pipeline.beside.TextsAround;
import arcomat.pipeline.recheck.OpenModels;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The models around a world on the disk.
 *
 * @param folder of the world's file, absolute
 */
record ProgramsBeside(Path folder, TextsAround around) implements WorldChoices.Programs {
    @Override
    public Stream<String> components(Optional<String> written) {
        Stream<OpenModels> models =
                written.isPresent()
                        ? around.models(folder.resolve(written.get()).normalize()).stream()
                        : around.all().stream();
        return models.flatMap(each -> WorldChoices.deployed(each.workspace()));
    }

    @Override
    public List<String> folders(String component) {
        return around.all().stream()
                .filter(
                        models ->
                                WorldChoices.deployed(models.workspace())
                                        .anyMatch(component::equals))
                .map(models -> folder.relativize(models.root()).toString().replace('\\', '/'))
                .map(path -> path.isEmpty() ? "." : path)
                .toList();
    }
}
