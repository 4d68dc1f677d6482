package arcomat.pipeline.check;

import arcomat.source.ComposedForm;
import arcomat.tree.Definition;
import arcomat.tree.Name;
import arcomat.tree.Unit;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Tells files that need none of those that something is wrong with. A file may need another one if
 * the name of what that one defines is a word of its text: nothing can be referred to without it.
 */
final class WholeFiles {
    private WholeFiles() {}

    /**
     * The paths of the files that are whole, with all that they need.
     *
     * @param wrong paths of those that are not; files that do not parse are among them
     */
    static Set<String> in(LoadedModels loaded, Set<String> wrong) {
        Map<Unit, Set<String>> open = new HashMap<>();
        Deque<String> missing = new ArrayDeque<>();
        for (Unit unit : loaded.units()) {
            if (wrong.contains(unit.file().path())) {
                name(unit).ifPresent(missing::add);
            } else {
                open.put(unit, WrittenNames.in(unit.file().text()));
            }
        }
        wrong.forEach(path -> missing.add(simpleName(path)));
        loaded.recovered().forEach(each -> name(each.unit()).ifPresent(missing::add));
        while (!missing.isEmpty()) {
            String name = missing.remove();
            Set<Unit> needing =
                    open.entrySet().stream()
                            .filter(each -> each.getValue().contains(name))
                            .map(Map.Entry::getKey)
                            .collect(Collectors.toSet());
            open.keySet().removeAll(needing);
            needing.forEach(unit -> name(unit).ifPresent(missing::add));
        }
        return open.keySet().stream()
                .map(unit -> unit.file().path())
                .collect(Collectors.toCollection(HashSet::new));
    }

    /** Of what others can refer to; that is never a test. */
    private static Optional<String> name(Unit unit) {
        return unit.definition()
                .match(
                        new Definition.Cases<>(
                                component -> Optional.of(component.name().text()),
                                automaton -> automaton.name().map(Name::text),
                                diagram -> Optional.of(diagram.name().text()),
                                suite -> Optional.empty()));
    }

    /** What a file defines, if it keeps to the rules. */
    static String simpleName(String path) {
        String file = ComposedForm.of(path.substring(path.lastIndexOf('/') + 1));
        int dot = file.lastIndexOf('.');
        return dot < 0 ? file : file.substring(0, dot);
    }
}
