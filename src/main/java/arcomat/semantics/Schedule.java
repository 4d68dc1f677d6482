package arcomat.semantics;

import arcomat.model.Component;
import arcomat.semantics.Composer.Draft;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.PriorityQueue;
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
            List<List<Draft>> readers = readers(drafts);
            List<Draft> ordered = sorted(drafts, readers);
            if (ordered.size() == drafts.size()) {
                return ordered;
            }
            drafts = dissolver.dissolve(drafts, compositesOnCycles(drafts, readers));
        }
    }

    /** For every draft, those that read one of its fresh messages; also numbers the drafts. */
    private static List<List<Draft>> readers(List<Draft> drafts) {
        List<List<Draft>> readers = new ArrayList<>(drafts.size());
        for (Draft draft : drafts) {
            draft.position = readers.size();
            readers.add(new ArrayList<>(2));
        }
        for (Draft draft : drafts) {
            for (Composer.Wire wire : draft.inputs) {
                if (wire.fresh()) {
                    readers.get(wire.sender().position).add(draft);
                }
            }
        }
        return readers;
    }

    /** Kahn's algorithm, the first declared of those that are ready; without what is on cycles. */
    private static List<Draft> sorted(List<Draft> drafts, List<List<Draft>> readers) {
        int[] awaited = new int[drafts.size()];
        readers.forEach(list -> list.forEach(reader -> awaited[reader.position]++));
        PriorityQueue<Integer> ready = new PriorityQueue<>();
        for (int i = 0; i < awaited.length; i++) {
            if (awaited[i] == 0) {
                ready.add(i);
            }
        }
        List<Draft> ordered = new ArrayList<>(drafts.size());
        while (!ready.isEmpty()) {
            int next = ready.remove();
            ordered.add(drafts.get(next));
            for (Draft reader : readers.get(next)) {
                if (--awaited[reader.position] == 0) {
                    ready.add(reader.position);
                }
            }
        }
        return ordered;
    }

    private Set<Draft> compositesOnCycles(List<Draft> drafts, List<List<Draft>> readers) {
        int[][] edges = new int[drafts.size()][];
        for (int i = 0; i < edges.length; i++) {
            edges[i] = readers.get(i).stream().mapToInt(d -> d.position).toArray();
        }
        Set<Draft> composites = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int[] cycle : new Cycles(edges).find()) {
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
