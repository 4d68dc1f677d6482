package blink;

import arcomat.guest.BehaviourLanguage;
import arcomat.guest.Guest;
import arcomat.guest.Meaning;
import arcomat.guest.SituatedLanguage;
import arcomat.guest.Vicinity;
import arcomat.guest.Vicinity.Kind;
import arcomat.guest.Vicinity.Value;
import arcomat.source.Span;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A lamp that is on for some slices and off for some: blink lit { on 3, off 2 }. */
public final class Blink implements Guest, SituatedLanguage {
    private static final Pattern PHASE = Pattern.compile("(on|off)\\s+([0-9]+)");

    @Override
    public int api() {
        return API;
    }

    @Override
    public String name() {
        return "blink";
    }

    @Override
    public List<BehaviourLanguage> languages() {
        return List.of(this);
    }

    @Override
    public String keyword() {
        return "blink";
    }

    @Override
    public Map<String, String> words() {
        return Map.of(
                "blink", "on for some slices and off for some, again and again",
                "on", "so many slices the port carries true",
                "off", "so many slices the port carries false");
    }

    @Override
    public Optional<String> layout(Written behaviour) {
        String phases = behaviour.body().text().strip().replaceAll("\\s+", " ");
        return phases.matches("\\w+ \\d+( ?, ?\\w+ \\d+)*")
                ? Optional.of(phases.replaceAll(" ?, ?", ", "))
                : Optional.empty();
    }

    @Override
    public void translate(Written behaviour, Vicinity around, Meaning meaning) {
        String port = behaviour.name().map(Name::text).orElse("");
        if (around.value(port).filter(Blink::isLamp).isEmpty()) {
            Span place = behaviour.name().map(Name::span).orElse(behaviour.keyword());
            meaning.problem(place, "say which output of Boolean blinks, as in blink lit {..}");
            return;
        }
        List<Span> phases = new ArrayList<>();
        Matcher phase = PHASE.matcher(behaviour.text());
        while (phase.find()) {
            phases.add(behaviour.part(phase.start(), phase.end()));
            if (phase.group(2).matches("0+")) {
                meaning.problem(phases.get(phases.size() - 1), "a phase has at least one slice");
            }
        }
        List<Slice> slices = slices(phases);
        for (int i = 0; i < slices.size(); i++) {
            Slice slice = slices.get(i);
            String next = slices.get((i + 1) % slices.size()).state();
            meaning.write(slice.place(), "state %s;", slice.state());
            if (i == 0) {
                meaning.write(slice.place(), "initial %s;", slice.state());
            }
            meaning.write(
                    slice.place(), "%s -> %s / {%s = %s};", slice.state(), next, port, slice.lit());
        }
    }

    private static boolean isLamp(Value value) {
        return value.kind() == Kind.OUTPUT && value.type().name().equals("Boolean");
    }

    private record Slice(Span place, String state, boolean lit) {}

    private static List<Slice> slices(List<Span> phases) {
        List<Slice> slices = new ArrayList<>();
        for (Span phase : phases) {
            String[] words = phase.text().split("\\s+");
            for (int i = 0; i < Integer.parseInt(words[1]); i++) {
                slices.add(new Slice(phase, "slice" + slices.size(), words[0].equals("on")));
            }
        }
        return slices;
    }
}
