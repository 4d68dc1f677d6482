package arcomat.generate.view;

import arcomat.generate.language.TypeName;
import arcomat.generate.view.NetworkView.MemberView;
import arcomat.generate.view.NetworkView.ShareView;

import java.util.List;

/**
 * Some parts of a large event-driven composite, or some sections of them.
 *
 * @param head of the composite
 * @param self the section's own class
 * @param members in the order in which they are visited
 * @param shares of the receivers of messages that go to many
 * @param whole name of the field that leads to the composite
 */
public record SubnetworkView(
        HeadView head,
        TypeName self,
        List<MemberView> members,
        List<ShareView> shares,
        String whole,
        boolean checks) {}
