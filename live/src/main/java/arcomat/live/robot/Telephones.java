package arcomat.live.robot;

import arcomat.sim.device.Hardware;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;

/** The connections of a brick: ports with the same peer share one. */
final class Telephones {
    private final Hardware brick;
    private final Routine routine;
    private final Map<String, Telephone> byPeer = new HashMap<>();

    /** In the order in which the program looks for one: the newest first. */
    private final Deque<String> begun = new ArrayDeque<>();

    /**
     * @param routine of the main thread, which looks for connections and begins them
     */
    Telephones(Hardware brick, Routine routine) {
        this.brick = brick;
        this.routine = routine;
    }

    Telephone to(String peer) {
        return byPeer.computeIfAbsent(peer, any -> new Telephone(brick, peer));
    }

    /** The first port that needs a connection has its thread started. */
    void begin(String peer) {
        for (String other : begun) {
            routine.loop();
            if (other.equals(peer)) {
                return;
            }
        }
        routine.loop();
        begun.push(peer);
        routine.call();
        routine.call(to(peer)::start);
    }
}
