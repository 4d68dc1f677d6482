package arcomat.pipeline.generate;

import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.semantics.network.Composition;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/** The parts of a program that works slice by slice: by their paths, the whole under none. */
public final class ProgramParts {
    private ProgramParts() {}

    /** All of them, those of parts included. */
    public static Map<String, Component> of(Component program) {
        Map<String, Component> all = new LinkedHashMap<>();
        all.put("", program);
        collect(program, "", all);
        return all;
    }

    private static void collect(Component component, String path, Map<String, Component> all) {
        boolean slices = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        if (component.isComposite() && !component.platform() && slices) {
            for (Composition.Node node : Composition.of(component).nodes()) {
                all.put(path + node.path(), node.component());
                collect(node.component(), path + node.path() + ".", all);
            }
        }
    }

    /**
     * The fields that lead from the object of a component to that of a part.
     *
     * @param path one of {@link #of}
     */
    public static String fields(Component component, String path, CodeLayout layout) {
        Map<String, String> fields =
                Objects.requireNonNull(layout.components().get(component.qualifiedName())).parts();
        for (Composition.Node node : Composition.of(component).nodes()) {
            String field = Objects.requireNonNull(fields.get(node.path()));
            if (node.path().equals(path)) {
                return field;
            }
            if (path.startsWith(node.path() + ".") && node.inside().isPresent()) {
                String rest = path.substring(node.path().length() + 1);
                return field + "." + fields(node.component(), rest, layout);
            }
        }
        throw new IllegalArgumentException(component.qualifiedName() + " has no part " + path);
    }
}
