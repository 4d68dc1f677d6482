package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.semantics.network.Composition;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/** The objects of compiled code that parts of a component are. */
public final class CodeParts {
    private final CodeLayout layout;
    private final Map<String, Part> parts = new LinkedHashMap<>();

    /** An instance: its component and its object. */
    public record Part(Component component, Object object) {}

    private CodeParts(CodeLayout layout) {
        this.layout = layout;
    }

    /**
     * The instances by their path, the whole under the empty path.
     *
     * @param object that is the whole
     */
    public static Map<String, Part> of(Component whole, Object object, CodeLayout layout) {
        CodeParts all = new CodeParts(layout);
        all.collect("", whole, object);
        return all.parts;
    }

    private void collect(String path, Component part, Object object) {
        parts.put(path, new Part(part, object));
        if (!part.isComposite() || part.platform()) {
            return;
        }
        String prefix = path.isEmpty() ? "" : path + ".";
        CodeLayout.Place place =
                Objects.requireNonNull(layout.components().get(part.qualifiedName()));
        for (Composition.Node node : Composition.of(part).nodes()) {
            String fields = Objects.requireNonNull(place.parts().get(node.path()));
            collect(prefix + node.path(), node.component(), Slot.follow(object, fields));
        }
    }
}
