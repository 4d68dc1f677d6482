package arcomat.pipeline.gate;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.ModelRoot;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Which old files have their place below the paths of the new models: only what was there can be
 * gone. Who names a single file or package asks about that alone.
 */
final class GateScope {
    private final CheckedModels base;
    private final CheckedModels fresh;
    private final PathNames names;
    private final List<Path> paths;
    private final Set<Path> roots;

    GateScope(CheckedModels base, CheckedModels fresh, List<String> paths, PathNames names) {
        this.base = base;
        this.fresh = fresh;
        this.names = names;
        this.paths = paths.stream().map(path -> PathNames.real(names.resolve(path))).toList();
        this.roots = fresh.loaded().roots(names);
        for (Recovered broken : fresh.loaded().recovered()) {
            Path file = names.resolve(broken.unit().file().path());
            ModelRoot.of(broken.unit(), file).ifPresent(roots::add);
        }
    }

    boolean contains(GateSide.Declared old) {
        Optional<Path> place = place(old.span().file().path());
        if (roots.isEmpty()) {
            // Where the new models are is not known if none of them can be read.
            return fresh.aside().isEmpty();
        }
        return place.isEmpty() || roots.stream().anyMatch(root -> holds(root, place));
    }

    private boolean holds(Path root, Optional<Path> place) {
        Path file = PathNames.real(root).resolve(place.orElseThrow());
        return paths.stream().anyMatch(file::startsWith);
    }

    /** Where a file is in its model root. */
    private Optional<Path> place(String path) {
        for (Unit unit : base.loaded().units()) {
            if (unit.file().path().equals(path)) {
                Path file = names.resolve(path).toAbsolutePath().normalize();
                return ModelRoot.of(unit, file).map(root -> root.relativize(file));
            }
        }
        return Optional.empty();
    }
}
