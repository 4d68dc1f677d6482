package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.Promise;

import java.util.Map;
import java.util.Set;

/**
 * A side of a comparison as naive enumeration sees it. What a state is, is its own business. In a
 * letter null is silence; ports that an output letter does not know are left aside.
 */
public interface NaiveMachine {
    /** An output that ends the run. */
    Map<String, Value> ERROR = Map.of("error", new Value.BooleanValue(true));

    static NaiveMachine of(Promise promise) {
        return promise.isComposition()
                ? new NaiveComposition(promise.component(), promise.arguments())
                : new NaiveAutomata(promise.behaviour());
    }

    Component component();

    /** Where it may be after these initial outputs. */
    Set<Object> starts(Map<String, Value> output);

    /** Where it may be after this step; empty where it cannot do it. */
    Set<Object> after(Object before, Map<String, Value> input, Map<String, Value> output);
}
