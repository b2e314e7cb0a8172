#include "zonal/gl/gpu_mesh.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace zonal {
namespace {

void add_attribute(std::uint32_t place, int components, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
}

}  // namespace

GpuMesh::GpuMesh(const Mesh& mesh) : index_count_(static_cast<int>(mesh.indices.size())) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
               mesh.indices.data(), GL_STATIC_DRAW);
  add_attribute(0, 3, offsetof(Vertex, position));
  add_attribute(1, 3, offsetof(Vertex, normal));
  add_attribute(2, 2, offsetof(Vertex, uv));
}

GpuMesh::~GpuMesh() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &indices_);
}

void GpuMesh::draw(int instances) const {
  glBindVertexArray(array_);
  glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, instances);
}

}  // namespace zonal
