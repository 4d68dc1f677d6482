package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;

/** Files that an earlier run has left: states of checks, baselines, and proofs. */
final class DamagedStates implements Kind {
    private static final Set<Integer> CHECKED = Set.of(0, 1, 2);

    private static final Set<Integer> DECIDED = Set.of(0, 1, 2, 3);

    private final Seeds seeds;

    DamagedStates(Seeds seeds) {
        this.seeds = seeds;
    }

    @Override
    public String name() {
        return "states";
    }

    @Override
    public Input draw(Dice dice) {
        SortedMap<String, byte[]> files = seeds.figures();
        int pair = dice.below(seeds.pairs().size());
        String file = dice.one("state", "baseline", pair + ".proof");
        byte[] good = seeds.made().get(file);
        ByteDamage damage = new ByteDamage(dice);
        byte[] bad = dice.below(2) == 0 ? damage.apply(good) : damage.applyToText(good);
        boolean forged = file.equals("state") && dice.below(2) == 0;
        files.put(file, forged ? forged(bad) : bad);
        String[] names = seeds.pairs().get(pair).split(" ");
        return new Input(
                files,
                switch (file) {
                    // What it says is believed then, but has to be said in order.
                    case "state" ->
                            forged
                                    ? List.of(
                                            Call.of(CHECKED, "check", "--state", file, "m", "b")
                                                    .writing(file))
                                    : List.of(
                                            Call.of(CHECKED, "check", "--state", file, "m", "b")
                                                    .writing(file),
                                            Call.of(CHECKED, "check", "m", "b"));
                    case "baseline" ->
                            List.of(Call.of(CHECKED, "check", "--baseline", file, "m", "b"));
                    default ->
                            List.of(
                                    verify(file, names[0], names[1]),
                                    // What does not hold has no proof, however damaged.
                                    verify(file, names[1], names[0]).refused());
                });
    }

    /** With the digest in its first line that belongs to the rest. */
    private static byte[] forged(byte[] state) {
        String text = new String(state, StandardCharsets.UTF_8);
        String rest = text.substring(text.indexOf('\n') + 1);
        try {
            byte[] digest =
                    MessageDigest.getInstance("SHA-256")
                            .digest(rest.getBytes(StandardCharsets.UTF_8));
            return (HexFormat.of().formatHex(digest) + "\n" + rest)
                    .getBytes(StandardCharsets.UTF_8);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A certificate; not decided is what it does not prove. */
    private static Call verify(String file, String left, String right) {
        return Call.of(DECIDED, "refines", "--verify-certificate", file, left, right, "m");
    }
}
