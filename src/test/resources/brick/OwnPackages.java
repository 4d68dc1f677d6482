//// lejos/nxt/Arm.java
package lejos.nxt;

public class Arm {}
//           ~~~ error ARC0913: lejos.nxt.Arm lies in a package that belongs to the brick; move it to one of your own

//// lejosteam/GoodArm.java
package lejosteam;

public class GoodArm {}
