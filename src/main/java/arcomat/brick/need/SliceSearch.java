package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.objectweb.asm.tree.analysis.BasicValue;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Looks for the heaviest slice among those that can follow each other from the start of a robot on.
 * Branches of several components that never come together do not count together here.
 */
final class SliceSearch {
    static final KnownValue ROBOT = KnownValue.object(0);

    private final Code code;
    private final LibraryCost library;
    private final String robot;

    /**
     * @param robot its class
     */
    SliceSearch(Code code, LibraryCost library, String robot) {
        this.code = code;
        this.library = library;
        this.robot = robot;
    }

    /**
     * @param weights of what slices do
     * @throws Unknown if there are too many slices to look at
     */
    long heaviest(MethodWeights weights) {
        StoreWalk walk = new StoreWalk(code, weights, false);
        Set<Store> seen = started();
        Deque<Store> open = new ArrayDeque<>(seen);
        long heaviest = 0;
        while (!open.isEmpty()) {
            Map<StoreWalk.End, Long> ends = called(walk, "slice", open.remove());
            for (Map.Entry<StoreWalk.End, Long> each : ends.entrySet()) {
                heaviest = Math.max(heaviest, each.getValue());
                if (seen.add(each.getKey().store())) {
                    open.add(each.getKey().store());
                }
            }
        }
        return heaviest;
    }

    /** What the robot's objects may hold before its first slice. */
    Set<Store> started() {
        StoreWalk walk = new StoreWalk(code, MethodWeights.none(code, library), true);
        Set<Store> started = new HashSet<>();
        for (StoreWalk.End made : called(walk, "<init>", walk.made(robot, Store.EMPTY)).keySet()) {
            called(walk, "start", made.store()).keySet().forEach(end -> started.add(end.store()));
        }
        return started;
    }

    private Map<StoreWalk.End, Long> called(StoreWalk walk, String name, Store store) {
        MethodName method =
                code.declaration(new MethodName(robot, name, "()V"))
                        .filter(declared -> code.method(declared).isPresent())
                        .orElseThrow(() -> new Unknown("the robot is not made as others are"));
        return walk.ends(method, List.<BasicValue>of(ROBOT), store);
    }
}
