package arcomat.semantics.network;

import arcomat.graph.Digraph;
import arcomat.graph.StrongComponents;
import arcomat.graph.TopologicalOrder;
import arcomat.model.Component;
import arcomat.semantics.network.Composer.Draft;

import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Orders nodes so that every fresh message is computed before it is read. */
final class Schedule {
    private final Component component;

    Schedule(Component component) {
        this.component = component;
    }

    /** Puts the nodes of some composites in their places. */
    interface Dissolver {
        List<Draft> dissolve(List<Draft> all, Set<Draft> composites);
    }

    List<Draft> order(List<Draft> declared, Dissolver dissolver) {
        List<Draft> drafts = declared;
        while (true) {
            Digraph readers = readers(drafts);
            List<Integer> order = TopologicalOrder.of(readers);
            if (order.size() == drafts.size()) {
                return order.stream().map(drafts::get).toList();
            }
            drafts = dissolver.dissolve(drafts, compositesOnCycles(drafts, readers));
        }
    }

    /** From every draft to those that read one of its fresh messages; also numbers the drafts. */
    @SuppressWarnings("NullAway") // a fresh message has a sender
    private static Digraph readers(List<Draft> drafts) {
        for (int i = 0; i < drafts.size(); i++) {
            drafts.get(i).position = i;
        }
        Digraph readers = new Digraph(drafts.size());
        for (Draft draft : drafts) {
            for (Composer.Wire wire : draft.inputs) {
                if (wire.fresh()) {
                    readers.addEdge(wire.sender().position, draft.position);
                }
            }
        }
        return readers;
    }

    private Set<Draft> compositesOnCycles(List<Draft> drafts, Digraph readers) {
        Set<Draft> composites = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int[] cycle : StrongComponents.of(readers).cyclic()) {
            boolean dissolvable = false;
            for (int member : cycle) {
                if (drafts.get(member).inside.isPresent()) {
                    composites.add(drafts.get(member));
                    dissolvable = true;
                }
            }
            if (!dissolvable) {
                throw new IllegalArgumentException(
                        Arrays.stream(cycle)
                                .mapToObj(i -> drafts.get(i).path)
                                .collect(
                                        Collectors.joining(
                                                ", ",
                                                component.qualifiedName()
                                                        + ": without any delay, messages circle"
                                                        + " between ",
                                                "")));
            }
        }
        return composites;
    }
}
