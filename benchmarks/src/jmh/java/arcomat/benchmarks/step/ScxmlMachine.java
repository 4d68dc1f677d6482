package arcomat.benchmarks.step;

import org.apache.commons.scxml.SCXMLExecutor;
import org.apache.commons.scxml.SCXMLListener;
import org.apache.commons.scxml.TriggerEvent;
import org.apache.commons.scxml.env.SimpleDispatcher;
import org.apache.commons.scxml.env.SimpleErrorReporter;
import org.apache.commons.scxml.env.jexl.JexlContext;
import org.apache.commons.scxml.env.jexl.JexlEvaluator;
import org.apache.commons.scxml.io.SCXMLParser;
import org.apache.commons.scxml.model.ModelException;
import org.apache.commons.scxml.model.SCXML;
import org.apache.commons.scxml.model.Transition;
import org.apache.commons.scxml.model.TransitionTarget;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

import java.io.IOException;
import java.io.StringReader;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

final class ScxmlMachine extends LibraryMachine {
    private final SCXMLExecutor machine;
    private final TriggerEvent[] events = new TriggerEvent[Letters.ALPHABET];

    ScxmlMachine() {
        for (int letter = 0; letter < events.length; letter++) {
            events[letter] = new TriggerEvent("letter" + letter, TriggerEvent.SIGNAL_EVENT);
        }
        List<Rule> rules = Rule.all();
        try {
            SCXML document = SCXMLParser.parse(new InputSource(new StringReader(xml(rules))), null);
            machine =
                    new SCXMLExecutor(
                            new JexlEvaluator(), new SimpleDispatcher(), new SimpleErrorReporter());
            machine.setStateMachine(document);
            machine.setRootContext(new JexlContext());
            machine.addListener(document, new Sender(rules));
            machine.go();
        } catch (IOException | SAXException | ModelException broken) {
            throw new IllegalStateException(broken);
        }
    }

    private static String xml(List<Rule> rules) {
        StringBuilder text = new StringBuilder();
        text.append(
                "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0'"
                        + " initialstate='state0'>");
        for (int state = 0; state < 5; state++) {
            text.append("<state id='state").append(state).append("'>");
            for (Rule rule : rules) {
                if (rule.source() == state) {
                    text.append("<transition event='letter").append(rule.letter());
                    text.append("' target='state").append(rule.target()).append("'/>");
                }
            }
            text.append("</state>");
        }
        return text.append("</scxml>").toString();
    }

    @Override
    protected void fire(int letter) {
        try {
            machine.triggerEvent(events[letter]);
        } catch (ModelException broken) {
            throw new IllegalStateException(broken);
        }
    }

    /** Source and target determine what is sent in this automaton. */
    private final class Sender implements SCXMLListener {
        private final Map<String, Rule> byStates = new HashMap<>();

        Sender(List<Rule> rules) {
            for (Rule rule : rules) {
                byStates.put("state" + rule.source() + "state" + rule.target(), rule);
            }
        }

        @Override
        public void onEntry(TransitionTarget state) {}

        @Override
        public void onExit(TransitionTarget state) {}

        @Override
        public void onTransition(TransitionTarget from, TransitionTarget to, Transition taken) {
            send(byStates.get(from.getId() + to.getId()));
        }
    }
}
