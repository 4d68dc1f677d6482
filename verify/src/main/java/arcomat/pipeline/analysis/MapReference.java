package arcomat.pipeline.analysis;

import arcomat.analysis.map.InterfaceMap;
import arcomat.model.Component;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Arguments;

import java.util.List;
import java.util.Optional;

/**
 * A map between the ports of two components, as it is written: a {@code <<map>>} component, in
 * which two others are declared, {@code Inputs} and {@code Outputs}, or one of them.
 */
record MapReference(String name) {
    private static final String INPUTS = "Inputs";
    private static final String OUTPUTS = "Outputs";

    /**
     * What it says.
     *
     * @throws WrongUse where there is no such component, or nothing is declared in it
     */
    InterfaceMap in(LoweredModels models) throws WrongUse {
        String qualified = MainComponent.component(name, models).qualifiedName();
        if (models.checked().workspace().components(qualified).stream()
                .noneMatch(each -> each.signature().isMap())) {
            throw new WrongUse("'%s' is no map; a map is a '<<map>> component'", qualified);
        }
        Optional<Promise> inputs = half(qualified, INPUTS, models);
        Optional<Promise> outputs = half(qualified, OUTPUTS, models);
        if (inputs.isEmpty() && outputs.isEmpty()) {
            throw new WrongUse(
                    "map '%s' declares neither a component '%s' nor a component '%s'",
                    qualified, INPUTS, OUTPUTS);
        }
        return new InterfaceMap(qualified, inputs, outputs);
    }

    private static Optional<Promise> half(String map, String half, LoweredModels models)
            throws WrongUse {
        Optional<Component> found = models.model().component(map + "." + half);
        if (found.isEmpty()) {
            return Optional.empty();
        }
        if (!found.get().hasDefaults()) {
            throw new WrongUse(
                    "'%s.%s' takes arguments, and in a map nobody gives them: give each parameter"
                            + " a default",
                    map, half);
        }
        return Optional.of(Promise.of(found.get(), Arguments.complete(found.get(), List.of())));
    }
}
