# SPDX-License-Identifier: BSD-3-Clause
"""FEBio models of specification 4.0 in the words of 3.0, 2.5 and 2.0, as far as contact cases need them.

Each function takes the root of the version above it and changes it in place.
"""
import re

OLD_PRIMARY, OLD_SECONDARY = "sla" "ve", "ma" "ster"
RIGID_DOFS = dict(zip(("Rx", "Ry", "Rz", "Ru", "Rv", "Rw"), ("x", "y", "z", "Rx", "Ry", "Rz")))
OLD_CONTACTS = {"sliding-node-on-facet": "sliding_with_gaps", "sliding-facet-on-facet": "facet-to-facet sliding",
                "sliding-elastic": "sliding-tension-compression"}


def child(parent, tag, text=None, **attributes):
    """Appends a new element."""
    element = parent.makeelement(tag, {k: v for k, v in attributes.items() if v is not None})
    element.text = text
    parent.append(element)
    return element


def section(parent, tag):
    found = parent.find(tag)
    return child(parent, tag) if found is None else found


def clear(element, keep=()):
    for part in list(element):
        if part.tag not in keep:
            element.remove(part)


def phases(root):
    """The root and its steps."""
    return [root] + root.findall("Step/step") + [s for s in root.findall("Step") if s.find("step") is None]


def to_3_0(root):
    root.set("version", "3.0")
    for phase in phases(root):
        for bc in phase.findall("Boundary/bc"):
            if bc.get("type") == "zero displacement":
                dofs = [c for c in "xyz" if bc.findtext(c + "_dof") == "1"]
                clear(bc)
                bc.set("type", "fix")
                child(bc, "dofs", ",".join(dofs))
            elif bc.get("type") == "prescribed displacement":
                bc.set("type", "prescribe")
                bc.find("value").tag = "scale"
        for bc in phase.findall("Rigid/rigid_bc"):
            bc.tag = "rigid_constraint"
            if bc.get("type") == "rigid_fixed":
                dofs = [d for d in RIGID_DOFS if bc.findtext(d + "_dof") == "1"]
                clear(bc, ("rb",))
                bc.set("type", "fix")
                child(bc, "dofs", ",".join(dofs))
            else:
                bc.set("type", "prescribe")
                dof = bc.find("dof")
                dof.text = "R" + dof.text if dof.text in "xyz" else dof.text
        for load in phase.findall("Rigid/rigid_load"):
            load.tag = "rigid_constraint"
            load.set("type", "force")
    for point in list(root.iter("pt")):
        point.tag = "point"


def ids(text):
    """Of a list with ranges."""
    for word in re.split(r"[,\s]+", text.strip()):
        first, *more = (int(n) for n in word.split(":"))
        yield from range(first, (more[0] if more else first) + 1, more[1] if len(more) > 1 else 1)


def geometry(root, numbers):
    domains = root.find("MeshDomains")
    root.remove(domains)
    materials = {d.get("name"): numbers[d.get("mat")] for d in domains}
    mesh = root.find("Mesh")
    mesh.tag = "Geometry"
    for elements in mesh.findall("Elements"):
        elements.set("mat", materials[elements.get("name")])
    for pair in mesh.findall("SurfacePair"):
        for tag, old in (("primary", OLD_PRIMARY), ("secondary", OLD_SECONDARY)):
            side = pair.find(tag)
            side.tag, side.text = old, side.set("surface", side.text.strip())
    for nodes in mesh.findall("NodeSet"):
        if nodes.text and nodes.text.strip():
            listed, nodes.text = list(ids(nodes.text)), None
            for i in listed:
                child(nodes, "node", id=str(i))


def old_boundary(bc, numbers):
    kind = bc.attrib.pop("type")
    bc.tag = kind
    if kind == "fix":
        bc.set("bc", bc.findtext("dofs"))
        clear(bc)
    elif kind == "prescribe":
        bc.set("bc", bc.findtext("dof").strip())
        clear(bc, ("scale", "relative"))
    else:
        bc.set("rb", numbers[bc.findtext("rb").strip()])
        clear(bc)


def rigid_bodies(phase, numbers):
    rigid = phase.find("Rigid")
    if rigid is None:
        return
    phase.remove(rigid)
    for part in rigid:
        body = child(section(phase, "Boundary"), "rigid_body", mat=numbers[part.findtext("rb").strip()])
        if part.get("type") == "fix":
            for dof in part.findtext("dofs").split(","):
                child(body, "fixed", bc=RIGID_DOFS[dof])
        else:
            value = part.find("value")
            child(body, "force" if part.get("type") == "force" else "prescribed", value.text,
                  bc=RIGID_DOFS[part.findtext("dof")], lc=value.get("lc"),
                  type="relative" if part.findtext("relative") == "1" else None)


def old_control(control):
    solver = control.find("solver")
    if solver is not None:
        control.extend([word for word in solver if word.tag != "qn_method"])
        control.remove(solver)
    analysis = control.find("analysis")
    if analysis is not None:
        analysis.set("type", analysis.text.strip().lower())
        analysis.text = None
    for word in control.findall("adaptor_re_solve"):
        control.remove(word)


def to_2_5(root):
    root.set("version", "2.5")
    numbers = {m.get("name"): m.get("id") for m in root.iter("material")}
    geometry(root, numbers)
    for phase in phases(root):
        for bc in phase.findall("Boundary/bc"):
            old_boundary(bc, numbers)
        rigid_bodies(phase, numbers)
        for control in phase.findall("Control"):
            old_control(control)
    for curve in root.findall("LoadData/load_controller"):
        curve.tag = "loadcurve"
        curve.set("type", curve.findtext("interpolate", "linear").strip().lower())
        curve.set("extend", curve.findtext("extend", "constant").strip().lower())
        points = curve.findall("points/point")
        clear(curve)
        curve.extend(points)
    for steps in root.findall("Step"):
        root.remove(steps)
        for step in steps:
            step.tag = "Step"
            root.append(step)


def to_2_0(root):
    """Rigid nodes stand in contacts and have no name there."""
    root.set("version", "2.0")
    mesh = root.find("Geometry")
    for tag, old in (("Nodes", "set"), ("Elements", "elset")):
        for part in mesh.findall(tag):
            if part.get("name"):
                part.set(old, part.attrib.pop("name"))
    pairs = {pair.get("name"): pair for pair in mesh.findall("SurfacePair")}
    for pair in pairs.values():
        mesh.remove(pair)
    for phase in phases(root):
        for boundary in phase.findall("Boundary"):
            for bc in list(boundary):
                if bc.tag in ("rigid", "rigid_body"):
                    boundary.remove(bc)
                if bc.tag == "rigid_body":
                    section(phase, "Constraints").append(bc)
                elif bc.tag == "rigid":
                    contact = child(section(phase, "Contact"), "contact", type="rigid")
                    for node in mesh.find(f"NodeSet[@name='{bc.get('node_set')}']"):
                        child(contact, "node", id=node.get("id"), rb=bc.get("rb"))
                else:
                    bc.set("set", bc.attrib.pop("node_set"))
                    bc.set("bc", bc.get("bc").replace(",", ""))
                if bc.tag == "prescribe":
                    scale = bc.find("scale")
                    bc.text = scale.text
                    bc.attrib.update(scale.attrib)
                    if bc.findtext("relative") == "1":
                        bc.set("type", "relative")
                    clear(bc)
        for contact in phase.findall("Contact/contact[@surface_pair]"):
            pair = pairs[contact.attrib.pop("surface_pair")]
            for side in (OLD_SECONDARY, OLD_PRIMARY):
                child(contact, "surface", type=side, set=pair.find(side).get("surface"))
            contact.set("type", OLD_CONTACTS.get(contact.get("type"), contact.get("type")))
