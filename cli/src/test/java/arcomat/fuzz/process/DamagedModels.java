package arcomat.fuzz.process;

import arcomat.fuzz.Damage;
import arcomat.fuzz.Dice;
import arcomat.fuzz.ModelSet;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Models with a wrong token, a wrong byte, or without their end; asked for all that one can ask.
 */
final class DamagedModels implements Kind {
    private static final Set<Integer> CHECKED = Set.of(0, 1, 2);
    private static final Set<Integer> DECIDED = Set.of(0, 1, 2, 3);
    private static final String[] LIMITS = {"--timeout", "4"};

    private final Seeds seeds;
    private final List<ModelSet> donors;

    DamagedModels(Seeds seeds) {
        this.seeds = seeds;
        this.donors =
                List.of(
                        ModelSet.folder("coffee", Seeds.COFFEE),
                        ModelSet.page("language", Path.of("docs/language.md")));
    }

    @Override
    public String name() {
        return "models";
    }

    @Override
    public Input draw(Dice dice) {
        SortedMap<String, byte[]> models =
                switch (dice.below(4)) {
                    case 0 -> seeds.coffee();
                    case 1 -> new TreeMap<>(dice.one(seeds.small()));
                    default -> new TreeMap<>(dice.one(seeds.sound()));
                };
        List<String> components = Seeds.components(models);
        String path = dice.one(List.copyOf(models.keySet()));
        models.put(path, damaged(models.get(path), dice));
        String one = components.isEmpty() ? "A" : dice.one(components);
        String other = components.isEmpty() ? "B" : dice.one(components);
        List<Call> calls = calls(dice.below(21), one, other, path);
        if (dice.below(4) == 0) {
            OldOutput.addTo(models);
        }
        return new Input(models, calls);
    }

    private byte[] damaged(byte[] file, Dice dice) {
        if (dice.below(2) == 0) {
            return new ByteDamage(dice).apply(file);
        }
        String text = new String(file, StandardCharsets.UTF_8);
        Damage damage = new Damage(donors, dice.below(Integer.MAX_VALUE));
        return damage.apply(text).getBytes(StandardCharsets.UTF_8);
    }

    private static List<Call> calls(int which, String one, String other, String path) {
        return switch (which) {
            case 0 -> List.of(checked("check", "m"));
            case 1 -> List.of(checked("check", "--format", "json", "m"));
            case 2 ->
                    List.of(
                            checked("check", "--report", "sarif=r.sarif", "--report", "junit=r.xml")
                                    .and("--profile", "executable", "m")
                                    .writing("r.sarif", "r.xml"));
            case 3 -> List.of(checked("check", "--format", "sarif", path));
            case 4 ->
                    List.of(
                            checked("format", path).writing(path),
                            checked("format", "--check", path));
            case 5, 6 -> List.of(out(checked("generate", "--target", "jvm", "m")));
            case 7 -> List.of(out(checked("generate", "--target", "lejos", "m")));
            case 8 -> List.of(decided("simulate", "--main", one, "--trace", "json", "m"));
            case 9 -> List.of(decided("simulate", "--main", one, "--engine", "compiled", "m"));
            case 10 -> List.of(decided("test", "--format", "junit", "m"));
            case 11 -> List.of(out(checked("diagram", "m")));
            case 12 -> List.of(decided("analyze", "--format", "json", "m").and(LIMITS));
            case 13 -> List.of(decided("verify", "--format", "json", "m").and(LIMITS));
            case 14 -> List.of(decided("refines", one, other, "m").and(LIMITS));
            case 15 -> List.of(out(decided("contradictions", one, "m").and(LIMITS)));
            case 16 -> List.of(decided("diff", "--format", "json", one, other, "m").and(LIMITS));
            case 17 -> List.of(out(decided("tests", one, "m").and(LIMITS)));
            case 18 -> List.of(out(decided("monitor", one, "m").and(LIMITS)));
            case 19 -> List.of(decided("mona", one, other, "--out", "q", "m").writing("q"));
            default -> List.of(decided("gate", "--base", "m", "m").and(LIMITS));
        };
    }

    private static Call checked(String... arguments) {
        return Call.of(CHECKED, arguments);
    }

    private static Call decided(String... arguments) {
        return Call.of(DECIDED, arguments);
    }

    private static Call out(Call call) {
        return call.and("--out", OldOutput.FOLDER).writing(OldOutput.FOLDER);
    }
}
