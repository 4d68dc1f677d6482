package arcomat.pipeline.campaign;

import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Where a program has one of its parts.
 *
 * @param path instance path; empty for the whole
 * @param component qualified name
 * @param fields that lead from the object of the whole to that of the part, with dots between them;
 *     empty for the whole
 */
record PartPlace(String path, String component, String fields) {
    /**
     * The whole, its parts, and theirs.
     *
     * @param layout of a robot's program, which is one
     */
    static List<PartPlace> all(CodeLayout layout) {
        Component whole = layout.wholes().get(0);
        List<PartPlace> all = new ArrayList<>();
        new PartPlace("", whole.qualifiedName(), "").collect(whole, layout, all);
        return all;
    }

    /** The full name of the class of the whole. */
    static String whole(CodeLayout layout) {
        return place(layout.wholes().get(0), layout).className();
    }

    private static CodeLayout.Place place(Component component, CodeLayout layout) {
        return Objects.requireNonNull(layout.components().get(component.qualifiedName()));
    }

    private void collect(Component here, CodeLayout layout, List<PartPlace> all) {
        all.add(this);
        if (here.isComposite() && !here.platform()) {
            Map<String, String> inside = place(here, layout).parts();
            for (Composition.Node node : Composition.of(here).nodes()) {
                String field = Objects.requireNonNull(inside.get(node.path()));
                Component part = node.component();
                new PartPlace(below(path, node.path()), part.qualifiedName(), below(fields, field))
                        .collect(part, layout, all);
            }
        }
    }

    private static String below(String above, String name) {
        return above.isEmpty() ? name : above + "." + name;
    }
}
