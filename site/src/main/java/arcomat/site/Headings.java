package arcomat.site;

import org.commonmark.ext.heading.anchor.IdGenerator;
import org.commonmark.node.Heading;
import org.commonmark.node.Node;
import org.commonmark.renderer.html.AttributeProvider;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** The headings of a page, with the names that links call them by. */
record Headings(List<Page.Heading> all, Map<Node, Page.Heading> byNode)
        implements AttributeProvider {

    static Headings of(Manuscript text) {
        IdGenerator ids = IdGenerator.builder().build();
        Map<Node, Page.Heading> byNode = new IdentityHashMap<>();
        List<Page.Heading> all =
                text.all(Heading.class).stream()
                        .map(
                                node -> {
                                    String words = Page.words(node);
                                    Page.Heading heading =
                                            new Page.Heading(
                                                    ids.generateId(words), words, node.getLevel());
                                    byNode.put(node, heading);
                                    return heading;
                                })
                        .toList();
        return new Headings(all, byNode);
    }

    /** What the page is called. */
    String title() {
        return all.isEmpty() ? "" : all.get(0).text();
    }

    @Override
    public void setAttributes(Node node, String tag, Map<String, String> attributes) {
        Page.Heading heading = byNode.get(node);
        if (heading != null) {
            attributes.put("id", heading.id());
        }
    }
}
