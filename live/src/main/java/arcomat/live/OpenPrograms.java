package arcomat.live;

import arcomat.pipeline.world.WorldChoices;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The models on the page, of which robots have their programs: all of them in one folder.
 *
 * @param world path of the world below that folder
 * @param models null as long as nothing was read
 */
record OpenPrograms(String world, @Nullable OpenModels models) implements WorldChoices.Programs {
    @Override
    public Stream<String> components(Optional<String> folder) {
        return models == null ? Stream.of() : WorldChoices.deployed(models.checked().workspace());
    }

    @Override
    public List<String> folders(String component) {
        return components(Optional.empty()).anyMatch(component::equals)
                ? List.of(wayUp())
                : List.of();
    }

    private String wayUp() {
        int above = (int) world.chars().filter(each -> each == '/').count();
        return above == 0 ? "." : "../".repeat(above).substring(0, 3 * above - 1);
    }
}
