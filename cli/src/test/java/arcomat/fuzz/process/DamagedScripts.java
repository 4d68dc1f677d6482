package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/** Scripts of what the sensors of a brick are to see. */
final class DamagedScripts implements Kind {
    private static final Set<Integer> RUN = Set.of(0, 1, 2, 3);

    /** A script, and the robot that it is for. */
    private record Pair(byte[] script, byte[] jar) {}

    private final List<Pair> pairs = new ArrayList<>();

    DamagedScripts(Seeds seeds) throws IOException {
        for (Map.Entry<String, byte[]> script :
                Seeds.read(Seeds.COFFEE.resolve("scripts"), "", ".*\\.script").entrySet()) {
            String robot = script.getKey().replace(".script", ".jar");
            String jar =
                    "brick/" + robot.substring(0, 1).toUpperCase(Locale.ROOT) + robot.substring(1);
            pairs.add(new Pair(script.getValue(), seeds.made().get(jar)));
        }
    }

    @Override
    public String name() {
        return "scripts";
    }

    @Override
    public Input draw(Dice dice) {
        Pair pair = dice.one(pairs);
        byte[] script = pair.script();
        ByteDamage damage = new ByteDamage(dice);
        byte[] damaged = dice.below(3) == 0 ? damage.apply(script) : damage.applyToText(script);
        SortedMap<String, byte[]> files =
                new TreeMap<>(Map.of("r.jar", pair.jar(), "s.script", damaged));
        Call call = Call.of(RUN, "run-brick", "--jar", "r.jar", "--script", "s.script");
        return new Input(files, List.of(call.and("--timeout", "4", "--trace", "json")));
    }
}
