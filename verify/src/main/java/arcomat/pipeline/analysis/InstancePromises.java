package arcomat.pipeline.analysis;

import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.semantics.Promise;
import arcomat.semantics.value.TooManyWays;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What all components of a model promise that have automata. A component with parameters is taken
 * with its defaults; one without defaults with the arguments of each of its instances.
 */
public final class InstancePromises {
    private static final String TYPES_MISSING =
            "is generic, and no part says its type arguments; name a model root with one that does";

    private final LoweredModels models;
    private final InstanceArguments instances;

    public InstancePromises(LoweredModels models) {
        this.models = models;
        this.instances = InstanceArguments.in(models.model());
    }

    /** Of the components in files that the user named. */
    public List<Promise> all() {
        List<Promise> promises = new ArrayList<>();
        for (Component component : withAutomata()) {
            if (component.isOnlyRun()) {
                continue;
            }
            for (List<Value> arguments : instances.orDefaultsOf(component)) {
                promises.add(new Promise(component, arguments, component.automata()));
            }
        }
        return promises;
    }

    /** Those of which nothing is known, as no instance says the arguments or they are too large. */
    List<Unexamined> open() {
        List<Unexamined> open = new ArrayList<>();
        for (Component component : withAutomata()) {
            if (component.isOnlyRun()) {
                open.add(new Unexamined(component.qualifiedName(), "has " + TooManyWays.REASON));
            } else if (instances.orDefaultsOf(component).isEmpty()) {
                open.add(new Unexamined(component.qualifiedName(), valuesMissing(component)));
            }
        }
        for (ComponentSymbol symbol : models.checked().workspace().components()) {
            if (isGenericWithoutPart(symbol)) {
                open.add(new Unexamined(symbol.qualifiedName(), TYPES_MISSING));
            }
        }
        return open;
    }

    private static String valuesMissing(Component component) {
        String name = component.qualifiedName();
        return "takes %s, which no part fixes; give them with --component '%s%s'"
                .formatted(
                        MainComponent.signature(component.parameters()),
                        name,
                        MainComponent.example(component.parameters()));
    }

    private boolean isGenericWithoutPart(ComponentSymbol symbol) {
        boolean behaves = !symbol.ownAutomata().isEmpty();
        return symbol.signature().isGeneric()
                && behaves
                && !symbol.isPlatform()
                && models.isNamed(symbol.nameSpan())
                && !isSpecialised(symbol, models.model());
    }

    /** Why nothing can be said of a generic component, where that is so. */
    static Optional<String> genericWithoutPart(ComponentSymbol symbol, Model model) {
        return isGenericInside(symbol) && !isSpecialised(symbol, model)
                ? Optional.of("it " + TYPES_MISSING)
                : Optional.empty();
    }

    private static boolean isGenericInside(ComponentSymbol symbol) {
        return symbol.signature().isGeneric()
                || symbol.enclosing().map(InstancePromises::isGenericInside).orElse(false);
    }

    private static boolean isSpecialised(ComponentSymbol symbol, Model model) {
        String specialised = symbol.qualifiedName() + "<";
        return model.components().stream()
                .anyMatch(each -> each.qualifiedName().startsWith(specialised));
    }

    private List<Component> withAutomata() {
        return models.named().stream()
                .filter(each -> !each.platform() && !each.automata().isEmpty())
                .toList();
    }
}
