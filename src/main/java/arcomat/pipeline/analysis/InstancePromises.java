package arcomat.pipeline.analysis;

import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.refinement.Promise;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.semantics.expression.Arguments;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What all components of a model promise that have automata. A component with parameters is taken
 * with its defaults; one without defaults with the arguments of each of its instances.
 */
public final class InstancePromises {
    private static final String TYPES_MISSING =
            "is generic, and no part says its type arguments; name a model root with one that does";

    private final Model model;
    private final CheckedModels checked;
    private final InstanceArguments instances;

    /**
     * @param checked the models that were lowered to the model
     */
    public InstancePromises(Model model, CheckedModels checked) {
        this.model = model;
        this.checked = checked;
        this.instances = InstanceArguments.in(model);
    }

    /** Of the components in files that the user named. */
    public List<Promise> all() {
        List<Promise> promises = new ArrayList<>();
        for (Component component : withAutomata()) {
            for (List<Value> arguments : arguments(component)) {
                promises.add(new Promise(component, arguments, component.automata()));
            }
        }
        return promises;
    }

    /** Those that promise nothing definite, since no instance says the arguments. */
    List<Unexamined> withoutArguments() {
        List<Unexamined> open = new ArrayList<>();
        for (Component component : withAutomata()) {
            if (arguments(component).isEmpty()) {
                open.add(new Unexamined(component.qualifiedName(), valuesMissing(component)));
            }
        }
        for (ComponentSymbol symbol : checked.workspace().components()) {
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
        boolean behaves = !symbol.ownAutomata().isEmpty() || !symbol.ownTables().isEmpty();
        return symbol.signature().isGeneric()
                && behaves
                && !symbol.isPlatform()
                && isNamed(symbol.nameSpan())
                && !isSpecialised(symbol, model);
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
        return model.components().stream()
                .filter(component -> isNamed(component.span()) && !component.platform())
                .filter(component -> !component.automata().isEmpty())
                .toList();
    }

    private boolean isNamed(Span span) {
        return checked.loaded().isNamedByUser(span.file().path());
    }

    private Set<List<Value>> arguments(Component component) {
        return component.hasDefaults()
                ? Set.of(Arguments.complete(component, List.of()))
                : instances.of(component);
    }
}
