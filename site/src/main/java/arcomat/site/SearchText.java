package arcomat.site;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.CustomNode;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.node.Paragraph;
import org.commonmark.node.SoftLineBreak;
import org.commonmark.node.Text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** What a search looks through: pages, section by section. */
final class SearchText {
    private SearchText() {}

    /** What stands below a heading. */
    record Section(Page.Heading heading, String text) {}

    static List<Section> of(Node document, Headings headings) {
        List<Section> sections = new ArrayList<>();
        StringBuilder text = new StringBuilder();
        Page.Heading current = null;
        for (Node at = document.getFirstChild(); at != null; at = at.getNext()) {
            Page.Heading next = headings.byNode().get(at);
            if (next == null) {
                text.append(words(at)).append(' ');
            } else {
                if (current != null) {
                    sections.add(new Section(current, text.toString().strip()));
                }
                text.setLength(0);
                current = next;
            }
        }
        if (current != null) {
            sections.add(new Section(current, text.toString().strip()));
        }
        return sections;
    }

    /** The words of a node, with blanks between those of its parts. */
    static String words(Node node) {
        StringBuilder words = new StringBuilder();
        node.accept(
                new AbstractVisitor() {
                    @Override
                    public void visit(Text text) {
                        words.append(text.getLiteral());
                    }

                    @Override
                    public void visit(Code code) {
                        words.append(code.getLiteral());
                    }

                    @Override
                    public void visit(SoftLineBreak lineBreak) {
                        words.append(' ');
                    }

                    @Override
                    public void visit(FencedCodeBlock block) {
                        words.append(block.getLiteral()).append(' ');
                    }

                    @Override
                    public void visit(CustomNode cell) {
                        visitChildren(cell);
                        words.append(' ');
                    }

                    @Override
                    public void visit(Paragraph paragraph) {
                        visitChildren(paragraph);
                        words.append(' ');
                    }
                });
        return words.toString().replaceAll("\\s+", " ");
    }

    /** A script that gives all sections to the page: address, page, heading and text of each. */
    static String script(Collection<Page> pages) {
        List<List<String>> rows = new ArrayList<>();
        for (Page page : pages) {
            for (Section section : page.sections()) {
                String at = section.heading().level() == 1 ? "" : "#" + section.heading().id();
                rows.add(
                        List.of(
                                page.address() + at,
                                page.title(),
                                section.heading().text(),
                                section.text()));
            }
        }
        try {
            return "window.sections = " + new ObjectMapper().writeValueAsString(rows) + ";\n";
        } catch (JsonProcessingException e) {
            throw new AssertionError(e);
        }
    }
}
