package arcomat.pipeline.recheck;

import arcomat.pipeline.check.LoadedModels;
import arcomat.syntax.Parsed;

import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/**
 * A file of open models, with all that answers about it may depend on: what it needs, and who uses
 * what it defines with what they need, since components are asked about as they are used. Nobody
 * uses tests.
 */
record AnswerScope(OpenModels open, String path) {

    /** As if the user had named the file. */
    LoadedModels models() {
        Set<String> scope = scope();
        List<Parsed> parsed = chosen(scope).stream().map(this::parsed).toList();
        Set<String> others = new HashSet<>(scope);
        others.remove(path);
        return new LoadedModels(
                List.of(path),
                chosen(scope).stream().flatMap(each -> open.source(each).stream()).toList(),
                parsed.stream().flatMap(each -> each.unit().stream()).toList(),
                parsed.stream().flatMap(each -> each.recovered().stream()).toList(),
                broken(scope),
                parsed.stream().flatMap(each -> each.findings().stream()).toList(),
                others,
                Set.of());
    }

    private Set<String> scope() {
        Dependencies dependencies = open.dependencies();
        FileInterface own = FileInterface.of(Objects.requireNonNull(open.remembered().get(path)));
        Set<String> users = new HashSet<>(dependencies.affectedBy(List.of(own)));
        users.removeIf(each -> each.endsWith(".mt"));
        users.add(path);
        return dependencies.neededBy(users);
    }

    /** In the order of the files. */
    private List<String> chosen(Set<String> scope) {
        return open.paths().stream().filter(scope::contains).toList();
    }

    private Set<String> broken(Set<String> scope) {
        Set<String> broken = new HashSet<>(scope);
        broken.removeIf(each -> parsed(each).unit().isPresent());
        return broken;
    }

    private Parsed parsed(String each) {
        return open.parsed(each).orElseThrow();
    }
}
