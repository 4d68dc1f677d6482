package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/** Folders of templates: a team's own target, from a neighbour or a download. */
final class DamagedTargets implements Kind {
    private static final Set<Integer> GENERATED = Set.of(0, 1, 2);

    private final Seeds seeds;
    private final List<SortedMap<String, byte[]>> targets;

    DamagedTargets(Seeds seeds) throws IOException {
        this.seeds = seeds;
        this.targets =
                List.of(
                        Seeds.read(Path.of("src/main/templates/jvm"), "t/", ".*"),
                        Seeds.read(Path.of("src/main/templates/lejos"), "t/", ".*"),
                        Seeds.read(Path.of("src/test/resources/targets/c"), "t/", ".*"));
    }

    @Override
    public String name() {
        return "targets";
    }

    @Override
    public Input draw(Dice dice) {
        SortedMap<String, byte[]> files =
                dice.below(3) == 0 ? seeds.coffee() : new TreeMap<>(dice.one(seeds.sound()));
        SortedMap<String, byte[]> target = dice.one(targets);
        ByteDamage damage = new ByteDamage(dice);
        files.putAll(target);
        for (int i = dice.below(2); i >= 0; i--) {
            String path = dice.one(List.copyOf(target.keySet()));
            byte[] file = files.get(path);
            files.put(path, dice.below(3) == 0 ? damage.apply(file) : damage.applyToText(file));
        }
        if (dice.below(2) == 0) {
            OldOutput.addTo(files);
            if (dice.below(4) == 0) {
                OldOutput.damage(files, damage);
            }
        }
        Call call = Call.of(GENERATED, "generate", "--target", "t", "--out", OldOutput.FOLDER, "m");
        return new Input(files, List.of(call.writing(OldOutput.FOLDER)));
    }
}
