package montiarc7;

import java.util.HashSet;
import java.util.Set;

/**
 * Where expressions and statements stand.
 *
 * @param present input ports that carry a message here
 */
record Scope(
        TypeNames types,
        Set<String> inputs,
        Set<String> outputs,
        Set<String> present,
        Lacks lacks) {
    Scope with(Set<String> more) {
        Set<String> all = new HashSet<>(present);
        all.addAll(more);
        return new Scope(types, inputs, outputs, all, lacks);
    }
}
