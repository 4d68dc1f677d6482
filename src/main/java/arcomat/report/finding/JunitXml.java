package arcomat.report.finding;

import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.text.Xml;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Cases in the XML of JUnit that build servers read. It has no schema of its own; the elements and
 * attributes are those that Ant's task brought up, with file and line as later tools added them.
 */
public final class JunitXml {
    private JunitXml() {}

    /**
     * @param name of all cases together: the command
     */
    public static String render(String name, List<Case> cases) {
        Map<String, List<Case>> groups = new LinkedHashMap<>();
        cases.forEach(c -> groups.computeIfAbsent(c.group(), g -> new ArrayList<>()).add(c));
        Xml xml = new Xml().open("testsuites", counted(name, cases));
        groups.forEach((group, members) -> write(xml, group, members));
        return xml.close("testsuites").text();
    }

    private static void write(Xml xml, String group, List<Case> members) {
        xml.open("testsuite", counted(group, members));
        members.forEach(member -> write(xml, member));
        xml.close("testsuite");
    }

    private static Map<String, String> counted(String name, List<Case> cases) {
        Map<String, String> attributes = new LinkedHashMap<>();
        attributes.put("name", name);
        attributes.put("tests", String.valueOf(cases.size()));
        attributes.put("failures", count(cases, Outcome.FAILED));
        attributes.put("errors", count(cases, Outcome.UNDECIDED));
        attributes.put("skipped", "0");
        return attributes;
    }

    private static String count(List<Case> cases, Outcome outcome) {
        return String.valueOf(cases.stream().filter(c -> c.outcome() == outcome).count());
    }

    private static void write(Xml xml, Case each) {
        Map<String, String> attributes = new LinkedHashMap<>();
        attributes.put("name", each.name());
        attributes.put("classname", each.group());
        each.place().ifPresent(place -> put(attributes, place));
        if (each.outcome() == Outcome.PASSED && each.details().isEmpty()) {
            xml.empty("testcase", attributes);
            return;
        }
        xml.open("testcase", attributes);
        switch (each.outcome()) {
            case PASSED -> xml.text("system-out", Map.of(), each.details());
            case FAILED -> xml.text("failure", message(each), each.details());
            case UNDECIDED -> xml.text("error", message(each), each.details());
        }
        xml.close("testcase");
    }

    private static void put(Map<String, String> attributes, Span place) {
        attributes.put("file", place.file().path());
        attributes.put("line", String.valueOf(place.startPosition().line()));
    }

    private static Map<String, String> message(Case each) {
        return Map.of("message", each.message());
    }

    /**
     * One thing that was looked at, with what came of it: a stream test, a promise, a file.
     *
     * @param group what it belongs to: a suite, a component
     * @param name unique in its group
     * @param place where it is written; a file without text is a place too
     * @param message in one sentence why it is not in order; empty where it is
     * @param details in lines what else there is to say, also of what is in order
     */
    public record Case(
            String group,
            String name,
            Optional<Span> place,
            Outcome outcome,
            String message,
            String details) {

        /** What came of it. */
        public enum Outcome {
            PASSED,
            FAILED,
            /** Nobody knows: it could not be decided. */
            UNDECIDED
        }
    }
}
