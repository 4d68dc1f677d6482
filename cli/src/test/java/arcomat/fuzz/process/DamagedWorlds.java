package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;

/** Worlds with the robots of the case study, which are compiled for it or lie beside it as jars. */
final class DamagedWorlds implements Kind {
    private static final Set<Integer> RUN = Set.of(0, 1, 2, 3);

    private final Seeds seeds;
    private final List<byte[]> worlds = new ArrayList<>();

    DamagedWorlds(Seeds seeds) throws IOException {
        this.seeds = seeds;
        for (byte[] world : Seeds.read(Seeds.COFFEE, "", ".*\\.world").values()) {
            String text = new String(world, StandardCharsets.UTF_8);
            String shorter =
                    text.replaceAll("(?m)^goal .*", "").replace("seconds 900", "seconds 20");
            worlds.add(bytes(shorter));
            worlds.add(
                    bytes(
                            shorter.replaceAll(
                                    "component coffee\\.\\w+\\.(\\w+) in \\.\\.", "jar $1.jar")));
        }
    }

    @Override
    public String name() {
        return "worlds";
    }

    @Override
    public Input draw(Dice dice) {
        byte[] world = dice.one(worlds);
        ByteDamage damage = new ByteDamage(dice);
        SortedMap<String, byte[]> files = seeds.coffee();
        files.put(
                "m/world/w.world",
                dice.below(3) == 0 ? damage.apply(world) : damage.applyToText(world));
        for (Map.Entry<String, byte[]> made : seeds.made().entrySet()) {
            if (made.getKey().endsWith(".jar")) {
                files.put(made.getKey().replaceFirst("brick/", "m/world/"), made.getValue());
            }
        }
        Call call = Call.of(RUN, "world", "m/world/w.world", "--timeout", "4");
        boolean page = dice.below(3) == 0;
        return new Input(
                files, List.of(page ? call.and("--report", "page").writing("page") : call));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
