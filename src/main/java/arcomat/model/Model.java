package arcomat.model;

import java.util.List;
import java.util.Optional;

/**
 * All components and tests of a set of files.
 *
 * @param components every component that needs no type arguments, and every instantiation of a
 *     generic one that a part asks for; ordered by qualified name
 */
public record Model(List<Component> components, List<StreamTest> tests) {
    public Model {
        components = List.copyOf(components);
        tests = List.copyOf(tests);
    }

    public Optional<Component> component(String qualifiedName) {
        return components.stream().filter(c -> c.qualifiedName().equals(qualifiedName)).findFirst();
    }
}
