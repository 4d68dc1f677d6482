package arcomat.analysis.evolution;

import arcomat.model.Component;
import arcomat.model.Model;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Which components differ between two models in what they say or in what they are made of. Nothing
 * is searched: the time is linear in the size of the models.
 */
public final class ChangeImpact {
    private final Set<String> own = new HashSet<>();
    private final Set<String> all = new HashSet<>();

    private ChangeImpact() {}

    public static ChangeImpact between(Model old, Model fresh) {
        ChangeImpact changed = new ChangeImpact();
        Map<String, Component> before = new HashMap<>();
        old.components().forEach(each -> before.put(each.qualifiedName(), each));
        Map<String, List<String>> users = new HashMap<>();
        for (Component component : fresh.components()) {
            String name = component.qualifiedName();
            Component namesake = before.get(name);
            if (namesake == null || !SameMeaning.own(component, namesake)) {
                changed.own.add(name);
            }
            for (String part : parts(component)) {
                users.computeIfAbsent(part, each -> new ArrayList<>()).add(name);
            }
        }
        changed.spread(users);
        return changed;
    }

    /** Names of the components of the parts, each once. */
    static Set<String> parts(Component component) {
        Set<String> names = new HashSet<>();
        if (component.body() instanceof Component.Composite composite) {
            composite.parts().forEach(part -> names.add(part.component().qualifiedName()));
        }
        return names;
    }

    private void spread(Map<String, List<String>> users) {
        Deque<String> open = new ArrayDeque<>(own);
        while (!open.isEmpty()) {
            String name = open.remove();
            if (all.add(name)) {
                open.addAll(users.getOrDefault(name, List.of()));
            }
        }
    }

    /** Whether it, or something that it is made of, says something else than before. */
    public boolean contains(Component component) {
        return all.contains(component.qualifiedName());
    }

    /** Whether it says something else itself; what its parts say does not count. */
    public boolean itself(Component component) {
        return own.contains(component.qualifiedName());
    }
}
