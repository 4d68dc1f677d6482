package arcomat.simulate.watch;

import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Says what was seen that none of the ways allows, and what they would have allowed. */
final class Accusation {
    private final List<Port> outputs;
    private final List<ConsistentRun> ways;

    Accusation(List<Port> outputs, List<ConsistentRun> ways) {
        this.outputs = outputs;
        this.ways = ways;
    }

    /**
     * @param judged positions of the ports that were looked at
     */
    String of(List<Integer> judged, Letter shown) {
        List<Integer> said = judged.stream().filter(this::isPromised).toList();
        Set<String> allowed = new LinkedHashSet<>();
        ways.forEach(way -> allowed.add(promised(way, said) + " (" + way.cause() + ")"));
        return " forbids " + seen(said, shown) + "; it allows " + String.join(" or ", allowed);
    }

    /** What ports show, as {@code y = 1, z = --}. */
    String seen(List<Integer> ports, Letter shown) {
        List<String> seen = new ArrayList<>();
        for (int port : ports) {
            String name = outputs.get(port).name();
            seen.add(name + " = " + new Sent.Messages(shown.messages(name)));
        }
        return String.join(", ", seen);
    }

    private boolean isPromised(int port) {
        return ways.stream()
                .anyMatch(way -> !(way.promised().ports().get(port) instanceof Sent.Anything));
    }

    private String promised(ConsistentRun way, List<Integer> ports) {
        List<String> promised = new ArrayList<>();
        for (int port : ports) {
            promised.add(outputs.get(port).name() + " = " + way.promised().ports().get(port));
        }
        return String.join(", ", promised);
    }
}
