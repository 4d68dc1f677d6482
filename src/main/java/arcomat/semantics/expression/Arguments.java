package arcomat.semantics.expression;

import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;

/** Arguments of a component. */
public final class Arguments {
    private Arguments() {}

    /**
     * Adds the defaults of the parameters that are not given.
     *
     * @param given values of the first parameters; all others have defaults
     * @return one per parameter
     */
    public static List<Value> complete(Component component, List<Value> given) {
        List<Parameter> parameters = component.parameters();
        List<Value> all = new ArrayList<>(given);
        while (all.size() < parameters.size()) {
            Scope scope = Scope.ofParameters(parameters, all);
            all.add(scope.constant(parameters.get(all.size()).initial().orElseThrow()));
        }
        return List.copyOf(all);
    }
}
