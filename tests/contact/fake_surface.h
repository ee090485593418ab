#pragma once
// A blank that is nothing but a few nodes: what contact needs, and no more.
#include "../blanks/dense_target.h"
#include "../conformance.h"
#include "../materials/material_point.h"

#include <deltaform/contact/contact_interface.h>
#include <deltaform/parameters/section.h>

#include <functional>
#include <memory>
#include <optional>

namespace deltaform
{
  namespace testing
  {
    /// Nodes with two unknowns and an offset, or (arm not zero) with a rotation that moves the contact point by the
    /// arm.
    class FakeSurface : public ContactSurface
    {
    public:
      explicit FakeSurface(const unsigned int n_nodes, const double arm_length = 0., const double node_offset = 0.)
        : X(n_nodes), arm(arm_length), offset(node_offset)
      {
        for (unsigned int i = 0; i + 1 < n_nodes; ++i)
          edges.push_back({{i, i + 1, invalid_index}});
      }

      unsigned int dofs_per_node() const
      {
        return arm > 0. ? 3 : 2;
      }

      unsigned int n_contact_dofs() const override
      {
        return X.size() * dofs_per_node();
      }

      unsigned int n_nodes() const override
      {
        return X.size();
      }

      unsigned int n_contact_points(Side) const override
      {
        return X.size();
      }

      double modulus() const override
      {
        return 1e3;
      }

      double flow_stress(Side, unsigned int) const override
      {
        return yield;
      }

      void contact_point(const Vector &q,
                         const Side side,
                         const unsigned int i,
                         ContactThickness,
                         ContactPoint &node) const override
      {
        node = ContactPoint();
        node.set_node(i);
        node.n_dofs = dofs_per_node();
        node.area = i == axis_node ? 0. : area;
        node.offset = offset;
        node.reference_coordinate = X[i][0];
        node.thickness = 2. * (arm + offset);
        node.compliance = compliance;
        for (unsigned int k = 0; k < node.n_dofs; ++k)
          node.dofs[k] = i * node.n_dofs + k;
        node.x = X[i] + Tensor1({q[node.dofs[0]], q[node.dofs[1]]});
        node.jacobian[0] = Tensor1({1., 0.});
        node.jacobian[1] = Tensor1({0., 1.});
        if (arm > 0.)
        {
          const double a = side == Side::top ? arm : -arm, theta = q[node.dofs[2]];
          node.x += a * Tensor1({-std::sin(theta), std::cos(theta)});
          node.jacobian[2] = -a * Tensor1({std::cos(theta), std::sin(theta)});
          node.second[2] = a * Tensor1({std::sin(theta), -std::cos(theta)});
        }
      }

      const std::vector<std::array<unsigned int, 3>> &contact_edges(Side) const override
      {
        return edges;
      }

      std::optional<FaceDirection>
      face_direction(const Vector &, Side, unsigned int, ContactThickness) const override
      {
        return face;
      }

      std::optional<FaceDirection> face; ///< the same at all nodes
      std::vector<Point2> X;
      double arm, offset, area = 1., compliance = 0., yield = std::numeric_limits<double>::infinity();
      unsigned int axis_node = invalid_index; ///< a node without area
      std::vector<std::array<unsigned int, 3>> edges;
    };

    /// One interface of a fake surface with a tool: entries of the sections Contact and Tools/tool.
    struct InterfaceFixture
    {
      using MakeCounterpart = std::function<std::unique_ptr<Counterpart>(const Tool &)>;

      InterfaceFixture(const ContactSurface &surface,
                       const Entries &contact_entries,
                       const Entries &tool_entries,
                       const MakeCounterpart &make = make_counterpart)
        : tree(ParameterTree::parse("", "test", all(contact_entries, tool_entries))),
          contact_section(tree.root().sub("Contact")), settings(contact_section, {{"thickness", 1.}}),
          tool("tool", tree.root().sub("Tools").sub("tool"), {{"thickness", 1.}}, {{"thickness", 1.}}),
          contact(surface, tool, make(tool), settings, tree.root().sub("Tools").sub("tool")),
          n_blank(surface.n_contact_dofs()),
          n(n_blank)
      {
        const bool own_unknowns = settings.normal_law->has_multiplier();
        n += own_unknowns ? contact.n_points() : 0;
        contact.set_dofs(n, n_blank);
        n += contact.projector().counterpart().n_unknowns();
      }

      static Entries all(const Entries &contact_entries, const Entries &tool_entries)
      {
        Entries result;
        for (const auto &entry : contact_entries)
          result.push_back("Contact/" + entry);
        for (const auto &entry : tool_entries)
          result.push_back("Tools/tool/" + entry);
        return result;
      }

      /// A blank of springs: stiffness @p k on every unknown.
      void read_stiffness(const Vector &q, const double k)
      {
        DenseTarget springs(n);
        springs.matrix.setIdentity();
        springs.matrix *= k;
        contact.read_stiffness(q, springs);
      }

      /// An increment from @p before (where a stage begins if it is the first) begins.
      void begin_increment(const Vector &before, const double time, const double k)
      {
        contact.begin_increment(before, time);
        read_stiffness(before, k);
        contact.predict_factors(before, nullptr);
      }

      DenseTarget assemble(const Vector &q, const bool tangent = true)
      {
        DenseTarget target(n, tangent);
        contact.assemble(q, target);
        return target;
      }

      /// Assemble such that the estimates of lambda are the forces, as they are at a converged state.
      DenseTarget converge(const Vector &q)
      {
        for (unsigned int k = 0; k < 2; ++k)
        {
          assemble(q);
          contact.prepare_step(Vector(n));
          contact.advance(1.);
        }
        return assemble(q);
      }

      ParameterTree tree;
      Section contact_section;
      ContactSettings settings;
      Tool tool;
      ContactInterface contact;
      unsigned int n_blank, n;
    };

    inline const Entries flat = {"Shape=plate", "Side=bottom", "Position z=0"};
  } // namespace testing
} // namespace deltaform
